// SPDX-License-Identifier: MIT
// The smallest complete use of Sole: a biped written down by hand stands with its left foot on a step. Shows where
// each ankle ends up and returns 1 where that is wrong.
#include "sole/sole.h"

#include <stdio.h>
#include <string.h>

#define STEP_HEIGHT 0.12f // m, of the ground on the character's left
#define ANKLE_HEIGHT 0.09f

enum
{
	pelvis,
	spine,
	chest,
	head,
	leftArm,
	rightArm,
	leftThigh,
	leftShin,
	leftFoot,
	leftToes,
	rightThigh,
	rightShin,
	rightFoot,
	rightToes,
	jointCount
};

static const char* const names[jointCount] = { "pelvis", "spine", "chest", "head", "left arm", "right arm",
	"left thigh", "left shin", "left foot", "left toes", "right thigh", "right shin", "right foot", "right toes" };

static const int32_t parents[jointCount] = { SOLE_NONE, pelvis, spine, chest, chest, chest, pelvis, leftThigh, leftShin,
	leftFoot, pelvis, rightThigh, rightShin, rightFoot };

// Where the joints are in the bind pose, in metres: x to the character's left, y up, z forward.
static const soleVec3 places[jointCount] = {
	{ 0.0f, 0.95f, 0.0f },
	{ 0.0f, 1.1f, 0.0f },
	{ 0.0f, 1.3f, 0.0f },
	{ 0.0f, 1.6f, 0.0f },
	{ 0.2f, 1.4f, 0.0f },
	{ -0.2f, 1.4f, 0.0f },
	{ 0.1f, 0.9f, 0.0f },
	{ 0.1f, 0.49f, 0.05f },
	{ 0.1f, ANKLE_HEIGHT, 0.0f },
	{ 0.1f, 0.03f, 0.13f },
	{ -0.1f, 0.9f, 0.0f },
	{ -0.1f, 0.49f, 0.05f },
	{ -0.1f, ANKLE_HEIGHT, 0.0f },
	{ -0.1f, 0.03f, 0.13f },
};

// One leg: four joints, the axis of the knee, and where the foot touches the floor. side is 1 for the left leg.
static soleLegDef makeLeg( const char* name, int32_t thigh, float side )
{
	float x = side * 0.1f;
	soleLegDef leg = soleDefaultLegDef();
	leg.name = name;
	leg.side = side > 0.0f ? sole_left : sole_right;
	leg.joints[0] = thigh;
	leg.joints[1] = thigh + 1;
	leg.joints[2] = thigh + 2;
	leg.jointCount = 3;
	leg.toes[0] = thigh + 3;
	leg.toeCount = 1;
	leg.hinge = soleVec( 1.0f, 0.0f, 0.0f );
	leg.sole.heel = soleVec( x, 0.0f, -0.06f );
	leg.sole.ball = soleVec( x, 0.0f, 0.13f );
	leg.sole.toe = soleVec( x, 0.0f, 0.2f );
	leg.sole.inner = soleVec( x - side * 0.045f, 0.0f, 0.13f );
	leg.sole.outer = soleVec( x + side * 0.045f, 0.0f, 0.13f );
	return leg;
}

// The ground is whatever the host says it is. This one is a floor with a step on the left; ask your physics here.
static soleHit castProbe( const soleProbe* probe )
{
	float ground = probe->start_w.x > 0.0f ? STEP_HEIGHT : 0.0f;
	float travel = probe->start_w.y - ground; // Sole probes along -up, and up is +y here
	soleHit hit = { .surface = SOLE_NONE, .asked_w = probe->start_w };
	if ( travel >= 0.0f && travel <= probe->length )
	{
		hit.hit = true;
		hit.layer = 1;
		hit.point_w = soleVec( probe->start_w.x, ground, probe->start_w.z );
		hit.normal_w = soleVec( 0.0f, 1.0f, 0.0f );
	}
	return hit;
}

// Height of a joint: its own place carried through all of its parents.
static float jointHeight( const soleTransform* pose, int32_t joint )
{
	soleVec3 place = pose[joint].translation;
	for ( int32_t i = parents[joint]; i != SOLE_NONE; i = parents[i] )
	{
		place = soleTransformPoint( pose[i], place );
	}
	return place.y;
}

static bool isNear( const char* what, float height, float wanted )
{
	bool good = height > wanted - 0.005f && height < wanted + 0.005f;
	printf( "%s at %.3f m, wanted %.3f m%s\n", what, (double)height, (double)wanted, good ? "" : ": WRONG" );
	return good;
}

int main( void )
{
	soleTransform pose[jointCount];
	for ( int32_t i = 0; i < jointCount; ++i )
	{
		pose[i] = soleTransform_Identity();
		pose[i].translation = parents[i] == SOLE_NONE ? places[i] : soleSub( places[i], places[parents[i]] );
	}

	soleRigDef def = soleDefaultRigDef();
	def.jointCount = jointCount;
	def.parents = parents;
	def.bindPose = pose;
	def.names = names;
	def.pelvis = pelvis;
	def.legs[0] = makeLeg( "left", leftThigh, 1.0f );
	def.legs[1] = makeLeg( "right", rightThigh, -1.0f );
	def.legCount = 2;

	soleRig* rig = NULL;
	soleMessage message;
	if ( soleCreateRig( &def, NULL, &rig, &message ) != sole_success )
	{
		fprintf( stderr, "%s\n", message.text );
		return 1;
	}
	soleSettings settings = soleDefaultSettings();
	soleState state = soleDefaultState( rig ); // one per character; copy it to save it

	soleTransform placed[jointCount];
	for ( int32_t i = 0; i < 120; ++i )
	{
		soleFrame frame = { .pose = pose, .root = soleTransform_Identity(), .timeStep = 1.0f / 60.0f, .weight = 1.0f };
		soleProbe probes[SOLE_MAX_PROBES];
		soleHit hits[SOLE_MAX_PROBES];
		int32_t count = soleGatherProbes( rig, &settings, &state, &frame, probes, SOLE_MAX_PROBES );
		for ( int32_t k = 0; k < count; ++k )
		{
			hits[k] = castProbe( &probes[k] );
		}
		soleOutput output;
		soleSolve( rig, &settings, &state, &frame, hits, count, &output );
		memcpy( placed, pose, sizeof placed );
		soleApply( rig, &output, placed );
	}
	soleDestroyRig( rig );

	bool left = isNear( "left ankle ", jointHeight( placed, leftFoot ), STEP_HEIGHT + ANKLE_HEIGHT );
	bool right = isNear( "right ankle", jointHeight( placed, rightFoot ), ANKLE_HEIGHT );
	return left && right ? 0 : 1;
}
