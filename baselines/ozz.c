// SPDX-License-Identifier: MIT
// The foot IK sample of ozz-animation, world space. Source: its description, and the sample's own page,
// guillaumeblanc.github.io/ozz-animation/samples/foot_ik.
//
// Order. Root height, rays, ankle targets, offset of the character, two-bone IK, aim IK. Each of the four switches
// leaves out its part; a leg whose ray meets nothing is left out of all of it.
//
// Ankle target. A the animated ankle, I what its ray met there, n that plane's normal. B, A's projection onto the
// plane, is AB = (A - I).n off. On the way from I to B the point H is where a perpendicular of length h meets the ray
// again:
//   H = I + (B - I) h / AB,   C = H + n h = I + (A - I) h / AB
// So the ankle stays on its ray and is h off the plane, which is h / (n.up) over it. The plane is taken for endless.
//
// Offset. d = max over the legs with ground of (C - A).(-up); all of the character moves by -d up. The leg that has to
// come down furthest keeps its animated bend, all others bend more. Where all ground is higher d is negative.
#include "baselines/ozz.h"

#include "baselines/baseline.h"
#include "baselines/ozz_jobs.h"

#include <string.h>

#define ENDLESS 1e5f // lengths of a ray that has no end

#define SAMPLE_LEG 0.93f // m, of the character for which the sample's lengths were chosen

// -------------------------------------------------------------------------------------------------------- settings

soleOzzSettings soleDefaultOzzSettings( void )
{
	soleOzzSettings settings = {
		.autoCharacterHeight = true,
		.pelvisCorrection = true,
		.twoBoneIk = true,
		.aimIk = true,
		.footHeight = 0.12f,
		.weight = 1.0f,
		.soften = 1.0f,
		.rootRayHeight = 10.0f,
		.ankleRayHeight = 0.5f,
		.aimHeight = 1.0f,
		.floorMask = 0xffffffffu,
	};
	for ( int32_t i = 0; i < SOLE_MAX_LEGS; ++i )
	{
		settings.axes[i] = ( soleOzzLegAxes ){
			.kneeMidAxis = { 0.0f, 0.0f, 1.0f },
			.kneePole = { 0.0f, 1.0f, 0.0f },
			.ankleUp = { -1.0f, 0.0f, 0.0f },
			.ankleForward = { 0.0f, 1.0f, 0.0f },
		};
	}
	return settings;
}

/// The knee's axes are at right angles to the shin, as a modeller lays them.
static soleOzzLegAxes soleMeasureOzzAxes( const soleRig* rig, const soleFrame* bind, int32_t index )
{
	soleBaselineLeg leg = soleReadBaselineLeg( rig, bind, index );
	soleQuat knee = soleGetBaselineJoint( rig, bind, leg.def.joints[leg.kneeIndex] ).rotation;
	soleVec3 down = soleNeg( soleRig_GetUp( rig ) );
	soleVec3 shin = soleNormalizeOr( soleSub( leg.ankle_w, leg.knee_w ), down );
	soleVec3 hinge = soleNormalizeOr( soleReject( leg.def.hinge, shin ), soleAnyOrthogonal( shin ) );
	soleVec3 forward = soleNormalizeOr( soleSub( leg.def.sole.toe, leg.def.sole.heel ), soleRig_GetForward( rig ) );
	soleVec3 up = soleNormalizeOr( soleReject( soleRig_GetUp( rig ), forward ), soleAnyOrthogonal( forward ) );
	return ( soleOzzLegAxes ){
		.kneeMidAxis = soleInvRotate( knee, soleNeg( hinge ) ),
		.kneePole = soleInvRotate( knee, soleCross( shin, hinge ) ),
		.ankleUp = soleInvRotate( leg.foot_w.rotation, up ),
		.ankleForward = soleInvRotate( leg.foot_w.rotation, forward ),
	};
}

void soleFitOzzSettings( const soleRig* rig, const soleTransform* bindPose, soleOzzSettings* settings )
{
	soleFrame bind = { .pose = bindPose, .root = soleTransform_Identity(), .up = soleRig_GetUp( rig ), .weight = 1.0f };
	int32_t count = soleRig_GetLegCount( rig );
	float length = 0.0f;
	float height = 0.0f;
	for ( int32_t i = 0; i < count; ++i )
	{
		length = soleMaxF( length, soleRig_GetLegLength( rig, i ) );
		height += soleGetBaselineAnkleHeight( rig, i ) / (float)count;
		settings->axes[i] = soleMeasureOzzAxes( rig, &bind, i );
	}
	settings->footHeight = height;
	float size = length / SAMPLE_LEG;
	settings->rootRayHeight *= size;
	settings->ankleRayHeight *= size;
	settings->aimHeight *= size;
}

soleOzzState soleDefaultOzzState( const soleRig* rig )
{
	(void)rig;
	soleOzzState state;
	memset( &state, 0, sizeof state );
	return state;
}

// ---------------------------------------------------------------------------------------------------------- probes

static soleProbe soleMakeOzzRay(
    const soleOzzSettings* settings, soleVec3 up, soleVec3 place, float height, float scale )
{
	return ( soleProbe ){
		.start_w = soleMulAdd( place, height * scale, up ),
		.direction_w = soleNeg( up ),
		.length = ENDLESS * scale,
		.mask = settings->floorMask,
	};
}

int32_t soleGatherOzz( const soleRig* rig, const soleOzzSettings* settings, const soleOzzState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	soleVec3 up = soleGetBaselineUp( rig, frame );
	float scale = frame->root.scale.x;
	float shift = frame->teleport ? 0.0f : state->rootShift;
	int32_t count = 1 + soleRig_GetLegCount( rig );
	for ( int32_t i = 0; i < count && i < capacity; ++i )
	{
		if ( i == 0 )
		{
			soleVec3 root = soleGetBaselineRoot( rig, frame ).translation;
			probes[i] = soleMakeOzzRay( settings, up, root, settings->rootRayHeight, scale );
			probes[i].leg = SOLE_NONE;
			probes[i].length = settings->autoCharacterHeight ? probes[i].length : 0.0f;
			continue;
		}
		soleVec3 ankle = soleMulAdd( soleReadBaselineLeg( rig, frame, i - 1 ).ankle_w, shift, up );
		probes[i] = soleMakeOzzRay( settings, up, ankle, settings->ankleRayHeight, scale );
		probes[i].leg = (int16_t)( i - 1 );
	}
	return count < capacity ? count : capacity;
}

// ----------------------------------------------------------------------------------------------------------- solve

/// One frame on its way.
typedef struct soleOzzWork
{
	const soleRig* rig;
	const soleOzzSettings* settings;
	soleOzzState* state;
	const soleFrame* frame;
	soleVec3 up;
	float scale;
	int32_t legCount;
	soleBaselineLeg legs[SOLE_MAX_LEGS];
	const soleHit* hits[SOLE_MAX_LEGS]; // NULL: nothing there
	soleVec3 shift;                     // of the root, then of the whole character
} soleOzzWork;

static const soleHit* soleGetOzzHit( const soleHit* hits, int32_t hitCount, int32_t index )
{
	return index < hitCount && hits[index].hit ? hits + index : NULL;
}

/// The root goes to what its ray has met. One that was not wanted was not cast.
static void soleMoveOzzRoot( soleOzzWork* work, const soleHit* hit )
{
	soleVec3 root = soleGetBaselineRoot( work->rig, work->frame ).translation;
	float height = hit != NULL ? soleDot( soleSub( hit->point_w, root ), work->up ) : 0.0f;
	work->state->rootShift = height * soleGetBaselineWeight( work->frame, SOLE_NONE );
	work->shift = soleScale( work->state->rootShift, work->up );
}

static void soleFindOzzTarget( const soleOzzWork* work, int32_t leg )
{
	soleVec3 ankle = soleAdd( work->legs[leg].ankle_w, work->shift );
	soleVec3 point = work->hits[leg]->point_w;
	soleVec3 way = soleSub( ankle, point );
	float off = soleDot( way, work->hits[leg]->normal_w );
	soleVec3* target = work->state->ankleTargets_w + leg;
	if ( fabsf( off ) > 1e-12f )
	{
		*target = soleMulAdd( point, work->settings->footHeight * work->scale / off, way );
	}
	else if ( work->state->hasTarget[leg] == false )
	{
		*target = ankle;
	}
	work->state->hasTarget[leg] = true;
}

/// The character goes down, or up, until the leg that has furthest to go is there.
static void soleMoveOzzPelvis( soleOzzWork* work )
{
	bool any = false;
	float furthest = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		if ( work->hits[i] != NULL )
		{
			soleVec3 ankle = soleAdd( work->legs[i].ankle_w, work->shift );
			float down = soleDot( soleSub( ankle, work->state->ankleTargets_w[i] ), work->up );
			furthest = any ? soleMaxF( furthest, down ) : down;
			any = true;
		}
	}
	if ( work->settings->pelvisCorrection && any )
	{
		float weight = soleGetBaselineWeight( work->frame, SOLE_NONE );
		work->shift = soleMulAdd( work->shift, -weight * furthest, work->up );
	}
}

/// Hip and knee so that the ankle comes to its target, or as they are.
static soleTwoBoneResult soleBendOzzLeg( const soleOzzWork* work, int32_t index, float weight )
{
	const soleBaselineLeg* leg = work->legs + index;
	const soleOzzLegAxes* axes = work->settings->axes + index;
	soleQuat knee = soleGetBaselineJoint( work->rig, work->frame, leg->def.joints[leg->kneeIndex] ).rotation;
	soleOzzTwoBoneJob job = soleDefaultOzzTwoBoneJob();
	job.start = soleAdd( leg->hip_w, work->shift );
	job.mid = soleAdd( leg->knee_w, work->shift );
	job.end = soleAdd( leg->ankle_w, work->shift );
	job.target = work->state->ankleTargets_w[index];
	job.midAxis = soleRotate( knee, axes->kneeMidAxis );
	job.poleVector = soleRotate( knee, axes->kneePole );
	job.soften = work->settings->soften;
	job.weight = work->settings->twoBoneIk ? weight : 0.0f;
	soleOzzTwoBoneResult solved = soleRunOzzTwoBone( &job );
	soleVec3 shin = soleRotate( solved.mid, soleSub( job.end, job.mid ) );
	return ( soleTwoBoneResult ){
		.hip = solved.start,
		.knee = solved.mid,
		.ankle = soleAdd( job.start, soleRotate( solved.start, soleAdd( soleSub( job.mid, job.start ), shin ) ) ),
		.flags = solved.reached ? 0u : (uint32_t)sole_legOutOfReach,
	};
}

/// The foot's rotation: its up along the ground's normal, its forward as the bent leg carries it.
static soleQuat soleAimOzzFoot( const soleOzzWork* work, int32_t index, const soleTwoBoneResult* bent, float weight )
{
	const soleOzzLegAxes* axes = work->settings->axes + index;
	soleQuat legTurn = soleMulQuat( bent->hip, bent->knee );
	soleQuat foot = soleMulQuat( legTurn, work->legs[index].foot_w.rotation );
	float height = work->settings->aimHeight * work->scale;
	soleOzzAimJob job = soleDefaultOzzAimJob();
	job.joint = bent->ankle;
	job.target = soleMulAdd( work->state->ankleTargets_w[index], height, work->hits[index]->normal_w );
	job.forward = soleRotate( foot, axes->ankleUp );
	job.up = soleRotate( foot, axes->ankleForward );
	job.poleVector = job.up;
	job.weight = work->settings->aimIk ? weight : 0.0f;
	return soleNormalizeQuat( soleMulQuat( soleRunOzzAim( &job ).turn, foot ) );
}

static void soleSolveOzzLeg( const soleOzzWork* work, int32_t index, soleLegOutput* output )
{
	soleWriteBaselineGround( work->rig, work->frame, work->hits[index], output );
	if ( work->hits[index] == NULL )
	{
		return;
	}
	float weight = soleClampF( work->settings->weight, 0.0f, 1.0f ) * soleGetBaselineWeight( work->frame, index );
	soleTwoBoneResult bent = soleBendOzzLeg( work, index, weight );
	soleBaselineGoal goal = {
		.pelvisOffset_w = work->shift,
		.ankle_w = work->state->ankleTargets_w[index],
		.foot_w = soleAimOzzFoot( work, index, &bent, weight ),
	};
	soleWriteBaselineLeg( work->rig, work->frame, work->legs + index, &goal, &bent, output );
	output->plantWeight = weight;
}

void soleSolveOzz( const soleRig* rig, const soleOzzSettings* settings, soleOzzState* state, const soleFrame* frame,
    const soleHit* hits, int32_t hitCount, soleOutput* output )
{
	soleOzzWork work = { .rig = rig, .settings = settings, .state = state, .frame = frame };
	work.up = soleGetBaselineUp( rig, frame );
	work.scale = frame->root.scale.x;
	work.legCount = soleRig_GetLegCount( rig );
	soleStartBaselineOutput( rig, frame, output );
	soleMoveOzzRoot( &work, soleGetOzzHit( hits, hitCount, 0 ) );
	for ( int32_t i = 0; i < work.legCount; ++i )
	{
		work.legs[i] = soleReadBaselineLeg( rig, frame, i );
		work.hits[i] = soleGetOzzHit( hits, hitCount, 1 + i );
		if ( work.hits[i] != NULL )
		{
			soleFindOzzTarget( &work, i );
		}
	}
	soleMoveOzzPelvis( &work );
	for ( int32_t i = 0; i < work.legCount; ++i )
	{
		soleSolveOzzLeg( &work, i, output->legs + i );
	}
	soleWriteBaselinePelvis( rig, frame, work.shift, output );
}
