// SPDX-License-Identifier: MIT
// A rig of two legs with hinged toes whose feet a test puts wherever it wants, and a gait with known contact times.
// Up is y, forward is z; the pelvis is joint 0, a leg has hip, knee, ankle, toe.
#ifndef TEST_MEASURE_RIG_H
#define TEST_MEASURE_RIG_H

#include "sole/measure.h"
#include "sole/sole.h"
#include "test.h"

#define RIG_JOINTS 9
#define RIG_PELVIS 0.95f
#define RIG_THIGH 0.45f
#define RIG_SHIN 0.42f
#define RIG_TOE_Z 0.14f // of the toe joint before the ankle
#define RIG_TOE_Y 0.03f // of the toe joint over the sole
#define RIG_ANKLE_Y 0.08f

static const int32_t rigParents[RIG_JOINTS] = { SOLE_NONE, 0, 1, 2, 3, 0, 5, 6, 7 };

/// The cmocka of Debian 12 compares floats only.
static inline void testNearD( double a, double b, double tolerance )
{
	if ( !( fabs( a - b ) <= tolerance ) )
	{
		print_error( "%.17g is not within %g of %.17g\n", a, tolerance, b );
		fail();
	}
}

static inline soleTransform rigAt( float x, float y, float z )
{
	soleTransform t = soleTransform_Identity();
	t.translation = soleVec( x, y, z );
	return t;
}

static inline soleQuat rigTurnX( double angle )
{
	return ( soleQuat ){ (float)sin( 0.5 * angle ), 0.0f, 0.0f, (float)cos( 0.5 * angle ) };
}

/// The bind pose: standing straight on the floor at height 0.
static inline void rigStand( soleTransform* pose )
{
	pose[0] = rigAt( 0.0f, RIG_PELVIS, 0.0f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleTransform* p = pose + 1 + 4 * leg;
		p[0] = rigAt( leg == 0 ? 0.1f : -0.1f, 0.0f, 0.0f );
		p[1] = rigAt( 0.0f, -RIG_THIGH, 0.0f );
		p[2] = rigAt( 0.0f, RIG_ANKLE_Y - RIG_PELVIS + RIG_THIGH, 0.0f );
		p[3] = rigAt( 0.0f, RIG_TOE_Y - RIG_ANKLE_Y, RIG_TOE_Z );
	}
}

/// @param second side of the second leg
static inline soleRig* rigMakeSided( soleSide second )
{
	soleTransform bind[RIG_JOINTS];
	rigStand( bind );
	soleRigDef def = soleDefaultRigDef();
	def.jointCount = RIG_JOINTS;
	def.parents = rigParents;
	def.bindPose = bind;
	def.pelvis = 0;
	def.legCount = 2;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		float x = leg == 0 ? 0.1f : -0.1f;
		float inner = leg == 0 ? -0.04f : 0.04f;
		soleLegDef* l = def.legs + leg;
		*l = soleDefaultLegDef();
		l->name = leg == 0 ? "left" : "right";
		l->side = leg == 0 ? sole_left : second;
		l->jointCount = 3;
		l->joints[0] = 1 + 4 * leg;
		l->joints[1] = 2 + 4 * leg;
		l->joints[2] = 3 + 4 * leg;
		l->toes[0] = 4 + 4 * leg;
		l->toeCount = 1;
		l->hinge = soleVec( 1.0f, 0.0f, 0.0f );
		l->sole.heel = soleVec( x, 0.0f, -0.06f );
		l->sole.ball = soleVec( x, 0.0f, RIG_TOE_Z );
		l->sole.toe = soleVec( x, 0.0f, 0.2f );
		l->sole.inner = soleVec( x + inner, 0.0f, RIG_TOE_Z );
		l->sole.outer = soleVec( x - inner, 0.0f, RIG_TOE_Z );
	}
	soleRig* rig = NULL;
	soleMessage message = { { 0 } };
	if ( soleCreateRig( &def, NULL, &rig, &message ) != sole_success )
	{
		print_error( "%s\n", message.text );
	}
	assert_non_null( rig );
	return rig;
}

static inline soleRig* rigMake( void )
{
	return rigMakeSided( sole_right );
}

/// Puts a foot so that its toe joint is moved by offset from where it stands and its heel is raised by an angle about
/// that joint; the toes stay flat. Hip and knee keep their rotations; the shin gets whatever length that takes.
static inline void rigPutFoot( soleTransform* pose, int32_t leg, soleVec3 offset, double heelRaise )
{
	soleTransform* p = pose + 1 + 4 * leg;
	soleQuat turn = rigTurnX( heelRaise );
	soleVec3 toe = soleAdd( offset, soleVec( p[0].translation.x, RIG_TOE_Y, RIG_TOE_Z ) );
	soleVec3 ankle = soleSub( toe, soleRotate( turn, p[3].translation ) );
	soleVec3 knee = soleAdd( pose[0].translation, soleAdd( p[0].translation, p[1].translation ) );
	p[2].translation = soleSub( ankle, knee );
	p[2].rotation = turn;
	p[3].rotation = soleConjugate( turn );
}

/// A motion of a rig and the memory behind it.
typedef struct rigMotion
{
	soleMotion motion;
	soleTransform* poses;
	soleTransform* roots;
	uint8_t* labels;
} rigMotion;

static inline soleTransform* rigPose( rigMotion* m, int32_t frame )
{
	return m->poses + (size_t)frame * RIG_JOINTS;
}

/// Everything stands still and is labelled as flat.
static inline rigMotion rigMakeMotion( const soleRig* rig, int32_t frameCount, float rate )
{
	size_t frames = (size_t)frameCount;
	rigMotion m = { .poses = malloc( frames * RIG_JOINTS * sizeof *m.poses ),
		.roots = malloc( frames * sizeof *m.roots ),
		.labels = malloc( 2 * frames ) };
	for ( int32_t t = 0; t < frameCount; ++t )
	{
		rigStand( rigPose( &m, t ) );
		m.roots[t] = soleTransform_Identity();
		m.labels[2 * t] = sole_labelFlat;
		m.labels[2 * t + 1] = sole_labelFlat;
	}
	m.motion = ( soleMotion ){ .rig = rig,
		.frameCount = frameCount,
		.frameRate = rate,
		.poses = m.poses,
		.roots = m.roots,
		.up = { 0.0f, 1.0f, 0.0f } };
	return m;
}

static inline void rigFreeMotion( rigMotion* m )
{
	free( m->poses );
	free( m->roots );
	free( m->labels );
}

// ----------------------------------------------------------------------------------------------------------- gait

/// A walk along z: each foot comes down flat, raises its heel, leaves the ground, swings at constant speed.
#define GAIT_PERIOD 1.0
#define GAIT_HEEL_OFF 0.45 // s after the foot came down
#define GAIT_TOE_OFF 0.6
#define GAIT_PHASE 0.5  // of the second leg
#define GAIT_FIRST 0.13 // s at which the first leg comes down first

/// Seconds since the foot last came down.
static inline double gaitPhase( int32_t leg, double time )
{
	double phase = fmod( time - GAIT_FIRST - leg * GAIT_PHASE, GAIT_PERIOD );
	return phase < 0.0 ? phase + GAIT_PERIOD : phase;
}

/// Fills in a walk at a speed. inPlace: the travel is in no pose and no root; else it is in the roots.
static inline void gaitFill( rigMotion* m, double speed, float floor, bool inPlace )
{
	for ( int32_t t = 0; t < m->motion.frameCount; ++t )
	{
		double time = t / (double)m->motion.frameRate;
		soleTransform* pose = rigPose( m, t );
		pose[0].translation.y = RIG_PELVIS + floor;
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			double phase = gaitPhase( leg, time );
			double stride = speed * GAIT_PERIOD;
			double swing = ( phase - GAIT_TOE_OFF ) / ( GAIT_PERIOD - GAIT_TOE_OFF );
			double raise = 6.0 * ( phase - GAIT_HEEL_OFF );
			// Against the root, which goes on at the walk's speed.
			double z = -speed * phase;
			double y = 0.0;
			if ( swing > 0.0 )
			{
				z += stride * swing;
				y = 0.12 * sin( 3.14159265 * swing );
				raise = 6.0 * ( GAIT_TOE_OFF - GAIT_HEEL_OFF ) * ( 1.0 - swing );
			}
			rigPutFoot(
			    pose, leg, soleVec( 0.0f, (float)y + floor, (float)( z + 0.3 * speed ) ), raise > 0.0 ? raise : 0.0 );
		}
		if ( inPlace == false )
		{
			m->roots[t].translation.z = (float)( speed * time );
		}
	}
}

// -------------------------------------------------------------------------------------------------------- terrain

/// A square of two triangles at a height, 40 m wide; tilted: rising by slope along z.
static inline soleTerrain* rigMakePlane( float height, float slope )
{
	float w = 20.0f;
	float positions[] = { -w, height - slope * w, -w, -w, height + slope * w, w, w, height + slope * w, w, w,
		height - slope * w, -w };
	uint32_t indices[] = { 0, 1, 2, 0, 2, 3 };
	soleTerrain* terrain = NULL;
	assert_int_equal( soleCreateTerrain( positions, 4, indices, 2, soleVec( 0.0f, 1.0f, 0.0f ), NULL, &terrain, NULL ),
	    sole_success );
	return terrain;
}

#define RIG_MAX_POINTS 1000

/// What to measure a motion with its own labels by: all points of the soles.
static inline soleMeasureDef rigMeasureDef( const rigMotion* m, const soleTerrain* terrain )
{
	static soleMeasurePoint points[RIG_MAX_POINTS];
	soleMeasureDef def = soleDefaultMeasureDef();
	def.motion = &m->motion;
	def.labels = m->labels;
	def.terrain = terrain;
	def.points = points;
	def.pointCount = soleMakeMeasurePoints( m->motion.rig, points, RIG_MAX_POINTS );
	assert_true( def.pointCount <= RIG_MAX_POINTS );
	return def;
}

/// Memory that fails from the n-th request on, and knows what is still held.
typedef struct rigMemory
{
	int32_t left;
	size_t held;
} rigMemory;

static inline void* rigAlloc( size_t byteCount, void* user )
{
	rigMemory* memory = user;
	if ( memory->left-- <= 0 )
	{
		return NULL;
	}
	memory->held += byteCount;
	return malloc( byteCount );
}

static inline void rigFree( void* block, size_t byteCount, void* user )
{
	rigMemory* memory = user;
	memory->held -= byteCount;
	free( block );
}

/// All figures over a plane of that height and slope.
static inline soleFigures rigMeasureOn( const rigMotion* m, const rigMotion* reference, float height, float slope )
{
	soleTerrain* terrain = rigMakePlane( height, slope );
	soleMeasureDef def = rigMeasureDef( m, terrain );
	def.reference = reference != NULL ? &reference->motion : NULL;
	soleFigures figures;
	soleMessage message = { { 0 } };
	soleResult result = soleMeasureMotion( &def, NULL, &figures, &message );
	assert_string_equal( message.text, "" );
	assert_int_equal( result, sole_success );
	soleDestroyTerrain( terrain );
	return figures;
}

static inline soleFigures rigMeasure( const rigMotion* m )
{
	return rigMeasureOn( m, NULL, 0.0f, 0.0f );
}

#endif
