// SPDX-License-Identifier: MIT
// Walk, run and low walk of the mannequin: foot paths, pelvis, trunk and arms over one stride. Root space, in place;
// phase 0 is the left foot's touch-down.
//
// The feet come first, the legs are solved to reach them. In stance a foot rolls over three fixed places, the rockers
// of J. Perry and J. Burnfield, "Gait Analysis", 2nd ed. 2010: over the heel's edge until it lies flat, about the toe
// joint with the toes flat, at last over the tip of the toes. Each is exact, so nothing slides. In swing the toe joint
// follows a curve that starts and ends with the velocity and acceleration of the stance. Pitch of the foot, clearance
// of the toes and the pelvis' and trunk's angles follow the shapes published by D. A. Winter, "Biomechanics and Motor
// Control of Human Movement", 4th ed. 2009, and "The Biomechanics and Motor Control of Human Gait", 1991, for walking,
// and by T. F. Novacheck, "The biomechanics of running", Gait & Posture 7 (1998), for running. The knots are this
// file's own.
#include "mannequin_parts.h"

#include <math.h>

/// mean + first and second harmonic, each as an amplitude and the phase of its maximum. Degrees or metres.
typedef struct toolWave
{
	double mean;
	double first;
	double firstPeak;
	double second;
	double secondPeak;
} toolWave;

#define SWING_KNOTS 3

typedef struct toolGait
{
	double duration; // of a stride, s
	double speed;    // m/s
	double lead;     // the flat foot's ankle ahead of the hips at touch-down, m
	double halfStep; // ankle to the side of the middle, m
	double toeOut;   // degrees
	double tipRoll;  // phase at which the toes start to roll over their tip
	double lift;     // phase of lift-off
	double liftToe;  // pitch of the toes then, degrees
	double liftRate; // its rate, degrees a stride
	int32_t pitchCount;
	double pitch[2 * TOOL_CURVE_KNOTS]; // phase from heel-off on, degrees
	double toeHeight[2 * SWING_KNOTS];  // share of the swing, m: the toe joint over the floor
	double toeAhead[2 * SWING_KNOTS];   // share of the swing, share of the way
	double circle;                      // how far the swinging foot goes outward, m
	toolWave hipsUp;
	toolWave hipsSide;
	toolWave hipsAhead;
	toolWave list;
	toolWave yaw;
	toolWave tilt;
	toolWave trunkTilt; // chest in root space, as the next two
	toolWave trunkList;
	toolWave trunkYaw;
	toolWave arm; // left shoulder's flexion
	toolWave elbow;
	double armOut;
	double armInward;
} toolGait;

// Toe clearance is least in the middle of the swing (Winter 1991: 1 to 2 cm).
static const toolGait s_walk = {
	.duration = tool_walkFrames / 60.0,
	.speed = 1.3,
	.lead = 0.296,
	.halfStep = 0.052,
	.toeOut = 6.0,
	.tipRoll = 0.48,
	.lift = 0.615,
	.liftToe = -30.0,
	.liftRate = -420.0,
	.pitchCount = 11,
	.pitch = { 0.28, 0, 0.37, -4, 0.47, -17, 0.56, -46, 0.615, -66, 0.66, -71, 0.74, -43, 0.83, -4, 0.91, 18, 1.0, 20,
	    1.085, 0 },
	.toeHeight = { 0.22, 0.098, 0.5, 0.064, 0.8, 0.110 },
	.toeAhead = { 0.25, 0.17, 0.5, 0.525, 0.75, 0.87 },
	.circle = 0.012,
	.hipsUp = { -0.0408, 0, 0, 0.0155, 0.29 },
	.hipsSide = { 0, 0.020, 0.31, 0, 0 },
	.hipsAhead = { 0, 0, 0, 0.008, 0.20 },
	.list = { 0, 4.0, 0.16, 0, 0 },
	.yaw = { 0, -5.0, 0.0, 0, 0 },
	.tilt = { 2.0, 0, 0, 1.0, 0.05 },
	.trunkTilt = { 2.0, 0, 0, 1.0, 0.06 },
	.trunkList = { 0, -1.0, 0.2, 0, 0 },
	.trunkYaw = { 0, 4.5, 0.02, 0, 0 },
	.arm = { -4.0, 19.0, 0.52, 0, 0 },
	.elbow = { 20.0, 9.0, 0.56, 0, 0 },
	.armOut = 7.0,
	.armInward = 14.0,
};

static const toolGait s_run = {
	.duration = tool_runFrames / 120.0,
	.speed = 3.3,
	.lead = 0.222,
	.halfStep = 0.030,
	.toeOut = 6.0,
	.tipRoll = 0.24,
	.lift = 0.360,
	.liftToe = -34.0,
	.liftRate = -420.0,
	.pitchCount = 11,
	.pitch = { 0.11, 0, 0.19, -10, 0.28, -37, 0.36, -68, 0.42, -87, 0.52, -99, 0.65, -72, 0.78, -26, 0.90, 3, 1.0, 11,
	    1.065, 0 },
	.toeHeight = { 0.25, 0.19, 0.55, 0.115, 0.82, 0.125 },
	.toeAhead = { 0.25, 0.18, 0.5, 0.55, 0.75, 0.88 },
	.circle = 0.012,
	.hipsUp = { -0.0765, 0, 0, 0.026, 0.425 },
	.hipsSide = { 0, 0.008, 0.18, 0, 0 },
	.hipsAhead = { 0, 0, 0, 0.006, 0.25 },
	.list = { 0, 5.0, 0.14, 0, 0 },
	.yaw = { 0, -6.0, 0.42, 0, 0 },
	.tilt = { 9.0, 0, 0, 1.5, 0.4 },
	.trunkTilt = { 8.0, 0, 0, 1.5, 0.2 },
	.trunkList = { 0, -2.0, 0.2, 0, 0 },
	.trunkYaw = { 0, 13.0, 0.03, 0, 0 },
	.arm = { -12.0, 34.0, 0.50, 0, 0 },
	.elbow = { 88.0, 12.0, 0.52, 0, 0 },
	.armOut = 13.0,
	.armInward = 28.0,
};

// Low: the knees stay bent, steps are short, the heel rises late and little, the trunk leans over the feet.
static const toolGait s_crouchWalk = {
	.duration = tool_walkFrames / 60.0,
	.speed = 0.8,
	.lead = 0.185,
	.halfStep = 0.075,
	.toeOut = 10.0,
	.tipRoll = 0.50,
	.lift = 0.615,
	.liftToe = -22.0,
	.liftRate = -300.0,
	.pitchCount = 11,
	.pitch = { 0.32, 0, 0.40, -4, 0.48, -14, 0.56, -34, 0.615, -48, 0.66, -52, 0.74, -34, 0.83, -6, 0.91, 10, 1.0, 12,
	    1.085, 0 },
	.toeHeight = { 0.22, 0.098, 0.5, 0.085, 0.8, 0.100 },
	.toeAhead = { 0.25, 0.17, 0.5, 0.525, 0.75, 0.87 },
	.circle = 0.015,
	.hipsUp = { -0.30, 0, 0, 0.010, 0.29 },
	.hipsSide = { 0, 0.022, 0.31, 0, 0 },
	.hipsAhead = { -0.05, 0, 0, 0.006, 0.20 },
	.list = { 0, 3.0, 0.16, 0, 0 },
	.yaw = { 0, -4.0, 0.0, 0, 0 },
	.tilt = { 18.0, 0, 0, 1.0, 0.05 },
	.trunkTilt = { 30.0, 0, 0, 1.0, 0.06 },
	.trunkList = { 0, -1.0, 0.2, 0, 0 },
	.trunkYaw = { 0, 4.0, 0.02, 0, 0 },
	.arm = { 10.0, 14.0, 0.52, 0, 0 },
	.elbow = { 45.0, 8.0, 0.56, 0, 0 },
	.armOut = 12.0,
	.armInward = 22.0,
};

static double toolRadians( double degrees )
{
	return degrees * ( TOOL_PI / 180.0 );
}

static double toolEvalWave( const toolWave* wave, double phase )
{
	return wave->mean + wave->first * cos( 2.0 * TOOL_PI * ( phase - wave->firstPeak ) ) +
	    wave->second * cos( 4.0 * TOOL_PI * ( phase - wave->secondPeak ) );
}

/// In radians.
static float toolWaveAngle( const toolWave* wave, double phase )
{
	return (float)toolRadians( toolEvalWave( wave, phase ) );
}

/// The curves of one foot over a stride, phase from its touch-down. Way and height of the toe joint along the foot's
/// heading, from where the heel touches down: floor fixed, not moving with the body.
typedef struct toolStride
{
	const toolGait* gait;
	toolCurve pitch;   // rad, from heel-off to foot-flat
	toolCurve tipRoll; // pitch of the toes in the last part of the stance
	toolCurve bend;    // toes over foot, in the swing
	toolCurve ahead;
	toolCurve up;
	toolCurve within; // the part of `ahead` that the rockers of the next stance take up again
} toolStride;

static double toolStridePitch( const toolStride* stride, double phase )
{
	const toolCurve* curve = &stride->pitch;
	double start = curve->t[0];
	double end = curve->t[curve->count - 1];
	double t = phase < start ? phase + 1.0 : phase;
	return t >= end ? 0.0 : toolEvalCurve( curve, t ).x;
}

static double toolStanceToePitch( const toolStride* stride, double phase )
{
	return phase > stride->gait->tipRoll ? toolEvalCurve( &stride->tipRoll, phase ).x : 0.0;
}

typedef struct toolPlace
{
	double ahead;
	double up;
} toolPlace;

/// Offset of a point of the foot from the point it turns about.
static toolPlace toolPitched( double ahead, double up, double pitch )
{
	return ( toolPlace ){ ahead * cos( pitch ) - up * sin( pitch ), ahead * sin( pitch ) + up * cos( pitch ) };
}

/// The toe joint in stance. Each rocker turns about a place that does not move.
static toolPlace toolStancePlace( const toolStride* stride, double phase )
{
	double ball = (double)TOOL_HEEL_BACK + (double)TOOL_BALL_AHEAD;
	double tip = (double)TOOL_TIP_AHEAD - (double)TOOL_BALL_AHEAD;
	double pitch = toolStridePitch( stride, phase );
	if ( pitch > 0.0 )
	{
		return toolPitched( ball, (double)TOOL_TOE_HEIGHT, pitch );
	}
	toolPlace fromTip = toolPitched( -tip, (double)TOOL_TOE_HEIGHT, toolStanceToePitch( stride, phase ) );
	return ( toolPlace ){ ball + tip + fromTip.ahead, fromTip.up };
}

/// Value and derivatives by differences: the curves are smooth far beyond this step.
static toolCurvePoint toolDifferences( double before, double at, double after, double step )
{
	return (
	    toolCurvePoint ){ at, ( after - before ) / ( 2.0 * step ), ( after - 2.0 * at + before ) / ( step * step ) };
}

static void toolStanceMotion( const toolStride* stride, double phase, toolCurvePoint* ahead, toolCurvePoint* up )
{
	const double step = 1e-4;
	toolPlace a = toolStancePlace( stride, phase - step );
	toolPlace b = toolStancePlace( stride, phase );
	toolPlace c = toolStancePlace( stride, phase + step );
	*ahead = toolDifferences( a.ahead, b.ahead, c.ahead, step );
	*up = toolDifferences( a.up, b.up, c.up, step );
}

static void toolFitSwing( toolStride* stride )
{
	const toolGait* gait = stride->gait;
	toolCurvePoint aheadLift;
	toolCurvePoint upLift;
	toolCurvePoint aheadLand;
	toolCurvePoint upLand;
	toolStanceMotion( stride, gait->lift, &aheadLift, &upLift );
	toolStanceMotion( stride, 0.0, &aheadLand, &upLand );
	const double within[] = { gait->lift, aheadLift.x, 1.0, aheadLand.x };
	stride->within = toolFitCurve( within, 2, aheadLift, aheadLand );
	aheadLand.x += gait->speed * gait->duration;

	double ahead[2 * ( SWING_KNOTS + 2 )] = { gait->lift, aheadLift.x };
	double up[2 * ( SWING_KNOTS + 2 )] = { gait->lift, upLift.x };
	for ( int32_t i = 0; i < SWING_KNOTS; ++i )
	{
		ahead[2 + 2 * i] = gait->lift + gait->toeAhead[2 * i] * ( 1.0 - gait->lift );
		ahead[3 + 2 * i] = aheadLift.x + gait->toeAhead[2 * i + 1] * ( aheadLand.x - aheadLift.x );
		up[2 + 2 * i] = gait->lift + gait->toeHeight[2 * i] * ( 1.0 - gait->lift );
		up[3 + 2 * i] = gait->toeHeight[2 * i + 1];
	}
	ahead[2 + 2 * SWING_KNOTS] = up[2 + 2 * SWING_KNOTS] = 1.0;
	ahead[3 + 2 * SWING_KNOTS] = aheadLand.x;
	up[3 + 2 * SWING_KNOTS] = upLand.x;
	stride->ahead = toolFitCurve( ahead, SWING_KNOTS + 2, aheadLift, aheadLand );
	stride->up = toolFitCurve( up, SWING_KNOTS + 2, upLift, upLand );
}

static toolStride toolMakeStride( const toolGait* gait )
{
	const toolCurvePoint rest = { 0 };
	toolStride stride = { .gait = gait };
	double pitch[2 * TOOL_CURVE_KNOTS];
	for ( int32_t i = 0; i < gait->pitchCount; ++i )
	{
		pitch[2 * i] = gait->pitch[2 * i];
		pitch[2 * i + 1] = toolRadians( gait->pitch[2 * i + 1] );
	}
	stride.pitch = toolFitCurve( pitch, gait->pitchCount, rest, rest );

	const double roll[] = { gait->tipRoll, 0.0, gait->lift, toolRadians( gait->liftToe ) };
	toolCurvePoint rollEnd = { .v = toolRadians( gait->liftRate ) };
	stride.tipRoll = toolFitCurve( roll, 2, rest, rollEnd );

	toolCurvePoint toe = toolEvalCurve( &stride.tipRoll, gait->lift );
	toolCurvePoint foot = toolEvalCurve( &stride.pitch, gait->lift );
	toolCurvePoint bent = { 0.0, toe.v - foot.v, toe.a - foot.a };
	double straight = gait->lift + 0.5 * ( 1.0 - gait->lift );
	const double bend[] = { gait->lift, toe.x - foot.x, straight, 0.0 };
	stride.bend = toolFitCurve( bend, 2, bent, rest );
	toolFitSwing( &stride );
	return stride;
}

/// In root space, moving with the body.
static toolFootPose toolPoseFoot( const toolStride* stride, int32_t side, double phase )
{
	const toolGait* gait = stride->gait;
	double mirror = side == 0 ? 1.0 : -1.0;
	double yaw = mirror * toolRadians( gait->toeOut );
	double pitch = toolStridePitch( stride, phase );
	double toePitch = pitch > 0.0 ? pitch : toolStanceToePitch( stride, phase );
	toolPlace place = toolStancePlace( stride, phase );
	double outward = 0.0;
	if ( phase > gait->lift )
	{
		place.ahead = toolEvalCurve( &stride->ahead, phase ).x;
		place.up = toolEvalCurve( &stride->up, phase ).x;
		toePitch = pitch + ( phase < stride->bend.t[1] ? toolEvalCurve( &stride->bend, phase ).x : 0.0 );
		double share = ( phase - gait->lift ) / ( 1.0 - gait->lift );
		outward = gait->circle * toolEase( 2.0 * share ) * toolEase( 2.0 - 2.0 * share );
	}
	// What the rockers do goes along the foot's own heading, the stride itself straight on.
	double within = phase > gait->lift ? toolEvalCurve( &stride->within, phase ).x : place.ahead;
	double stridePart = place.ahead - within;
	double footPart = within - (double)TOOL_HEEL_BACK;
	toolFootPose foot = {
		.toe = { (float)( mirror * ( gait->halfStep + outward ) + footPart * sin( yaw ) ), (float)place.up,
		    (float)( gait->lead + stridePart + footPart * cos( yaw ) - gait->speed * gait->duration * phase ) },
		.yaw = (float)yaw,
		.pitch = (float)pitch,
		.toePitch = (float)toePitch,
	};
	return foot;
}

static void toolPoseTrunk( const toolGait* gait, double phase, toolBodyPose* body )
{
	body->hips = soleVec( (float)toolEvalWave( &gait->hipsSide, phase ), (float)toolEvalWave( &gait->hipsUp, phase ),
	    (float)toolEvalWave( &gait->hipsAhead, phase ) );
	body->pelvis.tilt = toolWaveAngle( &gait->tilt, phase );
	body->pelvis.list = toolWaveAngle( &gait->list, phase );
	body->pelvis.yaw = toolWaveAngle( &gait->yaw, phase );
	// What the trunk does against the pelvis is shared by spine and chest, and undone again by neck and head.
	toolTurn trunk = { toolWaveAngle( &gait->trunkTilt, phase ), toolWaveAngle( &gait->trunkList, phase ),
		toolWaveAngle( &gait->trunkYaw, phase ) };
	toolTurn against = { trunk.tilt - body->pelvis.tilt, trunk.list - body->pelvis.list, trunk.yaw - body->pelvis.yaw };
	body->spine = ( toolTurn ){ 0.5f * against.tilt, 0.55f * against.list, 0.45f * against.yaw };
	body->chest = ( toolTurn ){ 0.5f * against.tilt, 0.45f * against.list, 0.55f * against.yaw };
	body->neck = ( toolTurn ){ -0.35f * trunk.tilt, -0.5f * trunk.list, -0.5f * trunk.yaw };
	body->head = ( toolTurn ){ -0.45f * trunk.tilt, -0.5f * trunk.list, -0.5f * trunk.yaw };
}

static void toolPoseGait( const toolGait* gait, double phase, toolBodyPose* body )
{
	toolStride stride = toolMakeStride( gait );
	toolPoseTrunk( gait, phase, body );
	for ( int32_t side = 0; side < 2; ++side )
	{
		double own = phase + 0.5 * side;
		own -= floor( own );
		body->feet[side] = toolPoseFoot( &stride, side, own );
		body->arms[side] = ( toolArmPose ){
			.flexion = toolWaveAngle( &gait->arm, own ),
			.abduction = (float)toolRadians( gait->armOut ),
			.inward = (float)toolRadians( gait->armInward ),
			.elbow = toolWaveAngle( &gait->elbow, own ),
			.wrist = 0.1f,
		};
	}
}

void toolPoseWalk( double phase, toolBodyPose* body )
{
	toolPoseGait( &s_walk, phase, body );
}

void toolPoseWalkRoot( double phase, toolBodyPose* body )
{
	toolPoseGait( &s_walk, phase, body );
	body->root.translation.z = (float)( s_walk.speed * s_walk.duration * phase );
}

void toolPoseCrouchWalk( double phase, toolBodyPose* body )
{
	toolPoseGait( &s_crouchWalk, phase, body );
}

void toolPoseRun( double phase, toolBodyPose* body )
{
	toolPoseGait( &s_run, phase, body );
}
