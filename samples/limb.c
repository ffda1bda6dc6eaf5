// SPDX-License-Identifier: MIT
// A hand that takes a cup and a head that looks at it: goals for limbs without any ground. Shows where hand and gaze
// end up and returns 1 where that is wrong.
#include "sole/limb.h"

#include <stdio.h>

enum
{
	pelvis,
	chest,
	neck,
	head,
	upperArm,
	foreArm,
	hand,
	jointCount
};

static const int32_t parents[jointCount] = { SOLE_NONE, pelvis, chest, neck, chest, upperArm, foreArm };

// Where the joints are in the bind pose, in metres: x to the character's left, y up, z forward. The arm hangs down, a
// little bent.
static const soleVec3 places[jointCount] = {
	{ 0.0f, 0.95f, 0.0f },
	{ 0.0f, 1.25f, 0.0f },
	{ 0.0f, 1.5f, 0.0f },
	{ 0.0f, 1.6f, 0.02f },
	{ 0.2f, 1.42f, 0.0f },
	{ 0.22f, 1.14f, -0.02f },
	{ 0.23f, 0.9f, 0.03f },
};

static soleLimbDef makeArm( const soleTransform* bindPose )
{
	soleLimbDef arm = soleDefaultLimbDef();
	arm.parents = parents;
	arm.jointCount = jointCount;
	arm.upper = upperArm;
	arm.lower = foreArm;
	arm.end = hand;
	soleLimbDef_FindHinge( &arm, bindPose );
	return arm;
}

static soleLookDef makeHead( void )
{
	soleLookDef look = soleDefaultLookDef();
	look.parents = parents;
	look.jointCount = jointCount;
	look.joints[0] = neck;
	look.joints[1] = head;
	look.shares[0] = 0.4f;
	look.shares[1] = 0.6f;
	look.lookCount = 2;
	look.eyes_l = soleVec( 0.0f, 0.08f, 0.1f );
	return look;
}

static bool isSmall( const char* what, float error )
{
	bool good = error < 0.001f;
	printf( "%s misses by %.5f%s\n", what, (double)error, good ? "" : ": WRONG" );
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
	soleLimbDef arm = makeArm( pose );
	soleLookDef look = makeHead();

	soleVec3 cup = soleVec( 0.3f, 1.1f, 0.38f );
	soleLimbGoal goal = { .position = cup, .rotation = soleQuat_Identity(), .positionWeight = 1, .rotationWeight = 1 };
	soleLimbHint elbow = { .position = soleVec( 0.8f, 0.8f, -0.3f ), .weight = 0.5f };
	soleLimbResult reached = soleSolveLimb( &arm, pose, &goal, &elbow );
	soleApplyLimb( &arm, &reached, pose );

	soleLookResult looked = soleSolveLookAt( &look, pose, cup, 1.0f );
	soleApplyLook( &look, &looked, pose );

	soleVec3 way = soleNormalizeOr( soleSub( cup, looked.eyes ), looked.gaze );
	bool good = isSmall( "the hand", soleDistance( reached.end, cup ) );
	return isSmall( "the gaze", soleDistance( way, looked.gaze ) ) && good && looked.flags == 0 ? 0 : 1;
}
