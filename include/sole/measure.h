// SPDX-License-Identifier: MIT
// Contact labels and quality figures of a placed motion. Offline: allocates, uses doubles, and asks the terrain by its
// own exact means, never by those of ground.h, so that it can't share their mistakes.
#ifndef SOLE_MEASURE_H
#define SOLE_MEASURE_H

#include "sole/types.h"

// -------------------------------------------------------------------------------------------------------- terrain

/// The exact surface that feet are measured against.
typedef struct soleTerrain soleTerrain;

/// @param positions x, y, z a vertex, world
/// @param up out of the ground, unit
SOLE_API soleResult soleCreateTerrain( const float* positions, int32_t vertexCount, const uint32_t* indices,
    int32_t triangleCount, soleVec3 up, const soleAllocator* allocator, soleTerrain** terrain, soleMessage* message );
SOLE_API void soleDestroyTerrain( soleTerrain* terrain );

/// Height over the ground that carries p: the highest surface with an upward face that is at most reach above p. Below
/// zero: p is under it. NaN where there is none.
SOLE_API double soleTerrain_GetGap( const soleTerrain* terrain, soleVec3 p, double reach );
/// How deep p is inside: 0 when it isn't, else the distance to the nearest surface.
SOLE_API double soleTerrain_GetDepth( const soleTerrain* terrain, soleVec3 p, double reach );

// --------------------------------------------------------------------------------------------------------- motion

/// A motion of a rig, sampled at a fixed rate.
typedef struct soleMotion
{
	const soleRig* rig;
	int32_t frameCount;
	float frameRate; // Hz
	/// frameCount * jointCount, parent-local.
	const soleTransform* poses;
	/// frameCount, character space to world.
	const soleTransform* roots;
	/// World.
	soleVec3 up;
	/// Height of the clip's own floor over the character's origin.
	float clipFloor;
} soleMotion;

/// A point of a sole, as a vertex skinned to one joint.
typedef struct soleMeasurePoint
{
	int32_t leg;
	int32_t joint;
	soleVec3 position; // in the joint's local space
	bool fore;         // in front of the ball
} soleMeasurePoint;

/// A dense grid over the five sole points of each leg: at most 5 mm apart along it for a leg of 0.9 m, three rows.
/// @return how many points there are; at most capacity are written.
SOLE_API int32_t soleMakeMeasurePoints( const soleRig* rig, soleMeasurePoint* points, int32_t capacity );

// --------------------------------------------------------------------------------------------------------- labels

typedef enum soleContactLabel
{
	sole_labelNone = 0,
	sole_labelHeel = 1,
	sole_labelToe = 2,
	sole_labelFlat = 3,
	sole_labelForce32 = 0x7fffffff
} soleContactLabel;

typedef struct soleLabelDef
{
	float speedOn;   // m/s default 0.15, raised to 10 % of the root's speed
	float speedOff;  // m/s default 0.30, raised likewise
	float heightOn;  // m default 0.02
	float heightOff; // m default 0.04
	float minimum;   // runs and gaps shorter than this are dropped and bridged. s default 0.05
	int32_t internalValue;
} soleLabelDef;

SOLE_API soleLabelDef soleDefaultLabelDef( void );

/// Height of the floor that a clip walks on, over the character's origin: the median height of the lowest cluster of
/// slow sole points.
SOLE_API float soleFindClipFloor( const soleMotion* motion );

/// Speed over the ground that an in-place clip pretends: median horizontal stance velocity, sign reversed; character
/// space. Zero for a clip that stands.
SOLE_API soleVec3 soleFindStrideVelocity( const soleMotion* motion );

/// Labels of a motion over flat ground.
/// @param labels frameCount * legCount, soleContactLabel each
SOLE_API soleResult soleLabelContacts(
    const soleMotion* motion, const soleLabelDef* def, const soleAllocator* allocator, uint8_t* labels );

/// The steps of a motion over flat ground, by its labels, in the order of their beginnings; of one that loops, those
/// that begin in its middle third, counted from there: give three rounds of it.
/// @param labels as soleLabelContacts() makes them
/// @return how many there are; at most capacity are written. 0 without memory.
SOLE_API int32_t soleFindSteps( const soleMotion* motion, const uint8_t* labels, bool loops,
    const soleAllocator* allocator, soleStep* steps, int32_t capacity );

// -------------------------------------------------------------------------------------------------------- figures

typedef struct soleStat
{
	double mean;
	double p95; // nearest rank
	double max;
} soleStat;

/// Figures of one leg. SI units.
typedef struct soleLegFigures
{
	int32_t labelledFrames;
	soleStat penetration;         // m, over labelled frames
	soleStat verticalPenetration; // m
	soleStat hover;               // m, over labelled frames
	double contactShare;          // 0..1, mean over labelled frames
	double slide;                 // m/s, mean over labelled pairs of frames
	soleStat drift;               // m per stance: mean and max (p95 over stances)
	int32_t stances;
	int32_t overExtended;       // frames
	int32_t swings;             // between two stances, long enough to have a middle
	int32_t scuffs;             // swings in whose middle a sole point is under the ground
	double clearance;           // m, least height of the sole in mid swing, 5th percentile over swings
	double kneeAccelerationRms; // rad/s^2
	double kneeAccelerationMax;
	double largestJump; // rad, largest change of a joint's local rotation in a frame
} soleLegFigures;

/// Figures of the whole motion. SI units.
typedef struct soleFigures
{
	int32_t legCount;
	soleLegFigures legs[SOLE_MAX_LEGS];
	soleLegFigures all;       // pooled over the legs
	double pelvisJerk;        // m/s^3, RMS of the third difference of pelvis height
	double pelvisLargestStep; // m, largest change of pelvis height in a frame
	double deviation;         // rad, RMS angle to the reference's local rotations over leg joints; 0 without one
	double pelvisOffsetRms;   // m, between the pelvises of motion and reference, each seen from its own root
	double pelvisOffsetMax;
} soleFigures;

typedef struct soleMeasureDef
{
	const soleMotion* motion;
	/// The same frames without foot placement, or NULL. Over-extension counts only where the reference is not.
	const soleMotion* reference;
	/// frameCount * legCount, made from the clip on flat ground.
	const uint8_t* labels;
	const soleTerrain* terrain;
	const soleMeasurePoint* points;
	int32_t pointCount;
	/// Frames left out at the start. default 0
	int32_t skip;
	/// frameCount: true where the motion does not go on from the frame before, as after the seam of a loop that is not
	/// closed. Differences across such a seam count for nothing. NULL: there is none.
	const bool* seams;
	int32_t internalValue;
} soleMeasureDef;

SOLE_API soleMeasureDef soleDefaultMeasureDef( void );
SOLE_API soleResult soleMeasureMotion(
    const soleMeasureDef* def, const soleAllocator* allocator, soleFigures* figures, soleMessage* message );

/// Figures as others have published them, to be put beside theirs. Definitions differ from those above and among each
/// other: heights are over the ground below the point, a foot's toe is its ball point, which moves as the toe joint
/// does but lies on the ground when the toes do; frames before skip and steps across seams are left out. What counts by
/// height speaks more of its threshold than of the motion, and figures a frame more of the frame rate; compare them on
/// one set of motions at one rate only. SI units.
typedef struct solePublishedFigures
{
	/// Horizontal step of the toes, weighted with 2 - 2^(h / H): 1 on the ground, 0 from H = 2.5 cm on; h is the larger
	/// height of the two frames. Mean over feet and frames. Zhang, Starke, Komura, Saito, ACM TOG 37(4), 2018.
	double mannStep;  // m a frame
	double mannSpeed; // m/s, the same times the rate
	/// The same with H = 3.3 cm. Ling, Zinno, Cheng, van de Panne, ACM TOG 39(4), 2020.
	double mvaeStep;
	double mvaeSpeed;
	/// Foot skating ratio: share of frames in which a toe is lower than 5 cm now and next, and moves horizontally at
	/// more than 0.5 m/s both in this step and on average over five steps around. At 20 Hz, to which the motion is
	/// resampled. Karunratanakul et al., GMD, ICCV 2023.
	double skatingRatio;
	/// Of the toes that are lower than 5 cm now and next, frame by frame, the share that moves at more than 0.2 m/s.
	/// nv-tlabs/kimodo, as are the next three.
	double kimodoRatio;
	/// Mean speed of toes that are lower than 5 cm. m/s
	double kimodoHeightSpeed;
	/// Speed of heels and toes that are labelled. m/s
	double kimodoContactSpeed;
	double kimodoContactMax;
	/// How much more than 5 mm the lowest sole point is under the ground, and above it. Means over frames, m. Yuan et
	/// al., PhysDiff, ICCV 2023, as are the next two.
	double physPenetration;
	double physFloat;
	/// Horizontal step of the lowest sole point where it is not higher than 5 mm now and next, else 0. Mean, m a frame.
	double physSkate;
	/// The last three added up.
	double physError;
	/// Physical foot contact score: mean over frames of the pelvis's acceleration, as a share of its largest, times the
	/// least horizontal step of ankle and toe on the left, times that on the right; falling counts as no acceleration.
	/// 10^-4 m^2. At 30 Hz, to which the motion is resampled. Not a number without legs on both sides. Tseng,
	/// Castellon, Liu, EDGE, CVPR 2023.
	double footContactScore;
} solePublishedFigures;

/// @param def as for soleMeasureMotion(); the reference is not used
SOLE_API soleResult soleMeasurePublished(
    const soleMeasureDef* def, const soleAllocator* allocator, solePublishedFigures* figures, soleMessage* message );

/// How far two samplings of one run at different rates are apart: distances of the same ankle and ball, m, over all
/// legs and the times that both have. Whole rates have the times of their greatest common divisor in common: 1/30 s for
/// 30 and 60 Hz, 1/12 s for 60 and 144.
/// @param start times before this one are left out, s
SOLE_API soleResult soleCompareMotions( const soleMotion* motion, const soleMotion* other, float start,
    const soleAllocator* allocator, soleStat* distance, soleMessage* message );

#endif
