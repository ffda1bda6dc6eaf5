// SPDX-License-Identifier: MIT
// What the steps of detection share: a skeleton made ready for looking at, the legs found so far, and the report.
// Everything is in character space, in the bind pose. Set-up code: libm is allowed, nothing here runs per frame.
#ifndef SOLE_RIG_DETECT_INTERNAL_H
#define SOLE_RIG_DETECT_INTERNAL_H

#include "sole/detect.h"

/// A human leg in metres. Lengths that are known for humans are turned to other sizes by the ratio of leg lengths.
#define SOLE_HUMAN_LEG 0.9f

/// Of a human foot, in metres at that leg.
#define SOLE_HUMAN_BAND 0.02f        // vertices this close to the sole plane belong to the sole
#define SOLE_HUMAN_ANKLE 0.085f      // ankle over the sole
#define SOLE_HUMAN_TOE_JOINT 0.02f   // toe joint over the sole
#define SOLE_HUMAN_HEEL 0.07f        // heel behind the ankle
#define SOLE_HUMAN_TOE 0.07f         // toe tip in front of the toe joint
#define SOLE_HUMAN_FOOT 0.2f         // toe tip in front of the ankle
#define SOLE_HUMAN_HALF_WIDTH 0.045f // of the ball
#define SOLE_HUMAN_ORIGIN 0.06f      // a floor this close to the origin is the origin's
#define SOLE_HUMAN_BALL 0.17f        // an end this close to the ankle is the ball's, not the toes'

/// Walks along parents stop here: hostile files have chains of any depth, legs don't.
#define SOLE_DETECT_WALK 64

/// What a name says of a joint.
typedef enum soleNamePart
{
	sole_partNone = 0,
	sole_partPelvis,
	sole_partHip,
	sole_partLeg, // the shin in "LeftUpLeg, LeftLeg", the thigh in "LeftLeg, LeftKnee"
	sole_partKnee,
	sole_partAnkle,
	sole_partToe,
	sole_partOther, // known and no part of a leg chain: buttock, hip joint, heel
	sole_partForce32 = 0x7fffffff
} soleNamePart;

typedef struct soleJointName
{
	soleNamePart part;
	soleSide side;
	uint32_t word; // hash of the word that named the part
	bool end;      // the name says that it only marks the end of a bone
	bool control;  // the name says that it is a helper: twist, IK target
	bool girdle;   // the name says that it carries a leg without being part of it
} soleJointName;

/// A leg on its way to a soleLegDef.
typedef struct soleFoundLeg
{
	int32_t joints[SOLE_MAX_LEG_JOINTS];
	int32_t jointCount;
	int32_t toes[SOLE_MAX_TOE_JOINTS];
	int32_t toeCount;
	int32_t tip; // a joint at the toes' end that is no toe joint, or SOLE_NONE
	int32_t detachedFoot;
	bool hasVirtualAnkle;
	bool ankleFromSkin; // the virtual ankle is where the skin ends
	soleVec3 ankle;     // of the ankle joint or virtual
	soleSide side;
	bool sideFromName;
	int32_t partner; // the leg on the other side, or SOLE_NONE
	float length;    // along the bones, hip to ankle
} soleFoundLeg;

typedef struct soleDetect
{
	const soleSkeleton* skeleton;
	soleDetectReport* report;
	int32_t jointCount;
	const int32_t* parents;

	int32_t* order;        // parents before children
	int32_t* childCount;   // per joint
	soleVec3* position;    // per joint
	soleQuat* rotation;    // per joint
	soleJointName* names;  // per joint
	int32_t* skinnedCount; // per joint: vertices that it moves most
	float* floats;         // three per joint, scratch of the step at work
	int32_t* ints;         // one per joint, likewise
	void* memory;
	size_t memoryBytes;

	/// Vertices of the skin that are usable, the joint that moves each most, and room for three floats each.
	int32_t* dominant;
	float* vertexFloats;
	void* skinMemory;
	size_t skinMemoryBytes;

	float size; // largest extent of the joints

	soleVec3 up;
	soleVec3 forward;
	soleVec3 lateral; // up x forward: to the left on right-handed axes
	bool standing;    // the bind pose has both feet flat at the same height
	float floor;      // height of what it stands on, told by joints
	int32_t pelvis;
	soleFoundLeg legs[SOLE_MAX_LEGS];
	int32_t legCount;
	bool byNames;
} soleDetect;

/// Adds a finding. leg and joint may be SOLE_NONE; where is made from them. mend may be empty.
void soleAddFinding(
    soleDetect* detect, soleSeverity severity, int32_t leg, int32_t joint, const char* mend, const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 6, 7 ) ) )
#endif
    ;

/// The name of a joint for messages: "joint 12" where it has none.
typedef struct soleJointLabel
{
	char text[48];
} soleJointLabel;
soleJointLabel soleLabelJoint( const soleDetect* detect, int32_t joint );
const char* soleNameLeg( const soleDetect* detect, int32_t leg );

/// Whether joint is ancestor or hangs below it.
bool soleDetect_IsBelow( const soleDetect* detect, int32_t joint, int32_t ancestor );
/// ints[joint]: 1 for a joint and all below it, 0 for all others.
void soleDetect_MarkBelow( soleDetect* detect, int32_t top );
/// The joint that ends the leg: detached foot, ankle, or the last one where the ankle is virtual.
int32_t soleFoundLeg_GetFoot( const soleFoundLeg* leg );
/// The first toe joint, else the joint that marks the end of the foot, else SOLE_NONE.
int32_t soleFoundLeg_GetEnd( const soleFoundLeg* leg );
/// What a metre of a human is on this leg.
float soleFoundLeg_GetUnit( const soleFoundLeg* leg );
void soleFoundLeg_Measure( const soleDetect* detect, soleFoundLeg* leg );
soleFoundLeg soleEmptyLeg( void );

// detect_ready.c
bool soleCheckSkeleton( soleDetect* detect );
bool soleAllocateDetect( soleDetect* detect );
/// Parents before children. False where parents run in a circle.
bool soleOrderJoints( soleDetect* detect );
bool solePlaceJoints( soleDetect* detect );
void soleCountChildren( soleDetect* detect );
void soleSortSkin( soleDetect* detect );

// detect_words.c
void soleParseNames( soleDetect* detect );

// detect_names.c
void soleFindLegsByRoles( soleDetect* detect );
void soleFindLegsByNames( soleDetect* detect );

// detect_pairs.c
/// Moves those that have a partner to the front. @return how many these are
int32_t soleKeepMirroredLegs( const soleDetect* detect, soleVec3 up, soleFoundLeg* legs, int32_t legCount );

// detect_structure.c
void soleFindLegsByStructure( soleDetect* detect );

// detect_axes.c
void soleFindUp( soleDetect* detect );
void soleFindForward( soleDetect* detect );
/// False where no joint carries all hips.
bool soleFindPelvis( soleDetect* detect );
void soleCheckLegs( soleDetect* detect );

// detect_hinge.c
/// The axis about which a knee bends.
soleVec3 soleFindHinge( soleDetect* detect, int32_t index );

// detect_toes.c
/// Toe joints and tip below the ankle.
void soleFindToes( soleDetect* detect, int32_t index );

// detect_stance.c
void soleFindStanding( soleDetect* detect );

// detect_sole.c
/// Where the skin ends below a leg without an ankle joint.
void soleFindVirtualAnkle( soleDetect* detect, int32_t index );
soleSolePoints soleFindSole( soleDetect* detect, int32_t index );

#endif
