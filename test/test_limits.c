// SPDX-License-Identifier: MIT
// What keeps figures from their targets: each cause is taken away, and what it kept back comes. Figures are those of
// sole/measure.h over walks at 60 frames a second; what is printed stands in docs/limits.md. Walks whose files are not
// there are left out, and said so.
#include "take.h"

#include <math.h>

#define TO_RADIANS 0.017453292519943295
#define WALKS 3

static const struct
{
	const char* name;
	const char* character;
	const char* clip;
} walks[WALKS] = {
	{ "mannequin", "mannequin", "walk" },
	{ "quaternius", "human-quaternius-ual/human-base-animations.glb", "Walk_Loop" },
	{ "pab", "human-pab-rootmotion/pab_arnaud.glb", "walk" },
};

/// @return false: the walk's file is not there
static bool openWalk( int32_t walk, const char* ground, testBake* bake, testTake* take )
{
	const char* character = walks[walk].character;
	if ( strchr( character, '.' ) != NULL && testData( character ) == NULL )
	{
		print_message( "left out: %s is not there\n", character );
		return false;
	}
	*bake = ( testBake ){ .character = character, .clip = walks[walk].clip, .ground = ground };
	testOpenTake( bake, take );
	return true;
}

// --------------------------------------------------------------------------------------------------------- ankles

static void freeAnkles( testTake* take )
{
	soleRigDef* def = &take->character.rigDef;
	for ( int32_t i = 0; i < def->legCount; ++i )
	{
		def->legs[i].ankleLimits.dorsiflexion = 1.5f;
	}
	soleRig* rig;
	assert_int_equal( soleCreateRig( def, NULL, &rig, NULL ), sole_success );
	soleDestroyRig( take->character.rig );
	take->character.rig = rig;
}

/// Shins that lean forward by more than an ankle bends raise the heels of flat feet.
static void anklesThatBendFurtherKeepSolesDown( void** state )
{
	(void)state;
	static const char* const grounds[] = { "T02", "T11-20", "T11-30" };
	for ( int32_t i = 0; i < 3 * WALKS; ++i )
	{
		testBake bake;
		testTake take;
		const char* ground = grounds[i / WALKS];
		if ( openWalk( i % WALKS, ground, &bake, &take ) == false )
		{
			continue;
		}
		testBakeTake( &bake, &take );
		soleLegFigures bound = take.figures.all;
		freeAnkles( &take );
		testBakeTake( &bake, &take );
		soleLegFigures free = take.figures.all;
		print_message(
		    "%-7s %-10s share %5.1f %%, drift %4.1f mm; with ankles that bend by 86 degrees %5.1f %%, %4.1f mm\n",
		    ground, walks[i % WALKS].name, 100.0 * bound.contactShare, 1e3 * bound.drift.max, 100.0 * free.contactShare,
		    1e3 * free.drift.max );
		assert_true( free.contactShare > 0.849 );
		assert_true( free.drift.max < 0.011 );
		testCloseTake( &take );
	}
}

// ---------------------------------------------------------------------------------------------------------- risers

static void lowerGround( testTake* take, double share )
{
	toolError error = { { 0 } };
	testStretchGround( &take->ground, 1.0f, (float)share, 1.0f );
	soleDestroyTerrain( take->terrain );
	TEST_GOOD( toolMakeTerrain( &take->ground, &take->terrain, &error ), error );
}

/// A stride of 1.4 m goes up or down five treads at once. The same stairs with lower risers ask for less.
static void kneesAreAsQuickAsRisersAreHigh( void** state )
{
	(void)state;
	static const double shares[] = { 1.0, 0.75, 0.5, 0.25 };
	for ( int32_t i = 0; i < WALKS; ++i )
	{
		double knee = 0.0, jump = 0.0;
		for ( int32_t k = 0; k < 4; ++k )
		{
			testBake bake;
			testTake take;
			if ( openWalk( i, "T02", &bake, &take ) == false )
			{
				break;
			}
			lowerGround( &take, shares[k] );
			testBakeTake( &bake, &take );
			const soleLegFigures *now = &take.figures.all, *input = &take.flat.all;
			knee = now->kneeAccelerationRms / input->kneeAccelerationRms;
			jump = now->largestJump / input->largestJump;
			print_message(
			    "risers of %3.0f mm, %-10s share %4.1f %%, knees %4.2f and steps of joints %4.2f of the clip's\n",
			    170.0 * shares[k], walks[i].name, 100.0 * now->contactShare, knee, jump );
			testCloseTake( &take );
		}
		assert_true( knee < 1.3 && jump < 1.75 );
	}
}

// ---------------------------------------------------------------------------------------------------------- rubble

#define MOST_POINTS 4096

/// Points of a sole over the ground, as it stands.
typedef struct Sole
{
	double ahead[MOST_POINTS], aside[MOST_POINTS], gap[MOST_POINTS]; // from the ball, and over the ground, m
	bool fore[MOST_POINTS];
	int32_t count;
} Sole;

static double getTouching( const double* gaps, int32_t count, double lower )
{
	int32_t touching = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		double gap = gaps[i] - lower;
		touching += gap >= -0.005 && gap <= 0.010;
	}
	return (double)touching / (double)count;
}

/// Share of the sole that touches, best of all ways to turn it and to bend its toes while it is no deeper in the
/// ground.
static double findBestShare( const Sole* sole, double depth )
{
	static double gaps[MOST_POINTS];
	double best = 0.0;
	for ( int32_t i = 0; i < 29 * 21 * 25; ++i )
	{
		double pitch = ( i % 29 - 14 ) * TO_RADIANS, roll = ( i / 29 % 21 - 10 ) * TO_RADIANS;
		double bend = ( i / ( 29 * 21 ) - 12 ) * 2.0 * TO_RADIANS;
		double least = HUGE_VAL;
		for ( int32_t k = 0; k < sole->count; ++k )
		{
			gaps[k] = sole->gap[k] + pitch * sole->ahead[k] + roll * sole->aside[k];
			gaps[k] += sole->fore[k] ? bend * sole->ahead[k] : 0.0;
			least = fmin( least, gaps[k] );
		}
		best = fmax( best, getTouching( gaps, sole->count, least + depth ) );
	}
	return best;
}

static void findSole( const testTake* take, int32_t frame, int32_t leg, Sole* sole )
{
	const toolCharacter* c = &take->character;
	soleSolePoints points = soleRig_GetLeg( c->rig, leg ).sole;
	int32_t foot = soleRig_GetFootJoint( c->rig, leg, false ), toes = soleRig_GetFootJoint( c->rig, leg, true );
	soleVec3 heel = testTakePoint( take, frame, foot, soleRig_ToFootSpace( c->rig, leg, points.heel, false ) );
	soleVec3 ball = testTakePoint( take, frame, toes, soleRig_ToFootSpace( c->rig, leg, points.ball, true ) );
	soleVec3 forward =
	    soleNormalizeOr( soleVec( ball.x - heel.x, 0.0f, ball.z - heel.z ), soleVec( 0.0f, 0.0f, 1.0f ) );
	soleVec3 side = soleCross( soleVec( 0.0f, 1.0f, 0.0f ), forward );
	sole->count = 0;
	for ( int32_t i = 0; i < c->pointCount && sole->count < MOST_POINTS; ++i )
	{
		const soleMeasurePoint* point = c->points + i;
		if ( point->leg == leg )
		{
			soleVec3 place = testTakePoint( take, frame, point->joint, point->position );
			soleVec3 from = soleSub( place, ball );
			sole->ahead[sole->count] = (double)soleDot( from, forward );
			sole->aside[sole->count] = (double)soleDot( from, side );
			sole->gap[sole->count] = soleTerrain_GetGap( take->terrain, place, 0.45 );
			sole->fore[sole->count++] = point->fore;
		}
	}
}

/// No way to turn a sole and to bend its toes brings 85 % of it to the rubble where it stands without sinking in.
static void noSoleLiesFlatOnRubble( void** state )
{
	(void)state;
	static Sole sole;
	for ( int32_t i = 0; i < WALKS; ++i )
	{
		testBake bake;
		testTake take;
		if ( openWalk( i, "rubble", &bake, &take ) == false )
		{
			continue;
		}
		testBakeTake( &bake, &take );
		toolTake labelled;
		toolError error = { { 0 } };
		TEST_GOOD( toolMakeBakeTake( &take.character, &take.result, &labelled, &error ), error );
		double has = 0.0, dry = 0.0, sunk = 0.0;
		int32_t count = 0;
		for ( int32_t index = 2 * labelled.skip; index < 2 * labelled.frameCount; index += 3 )
		{
			if ( labelled.labels[index] == sole_labelFlat )
			{
				findSole( &take, index / 2, index % 2, &sole );
				has += getTouching( sole.gap, sole.count, 0.0 );
				dry += findBestShare( &sole, 0.0 );
				sunk += findBestShare( &sole, 0.002 );
				count += 1;
			}
		}
		toolFreeTake( &labelled );
		print_message( "rubble %-10s share %4.1f %%; best of all turns %4.1f %%, 2 mm deep %4.1f %%\n", walks[i].name,
		    100.0 * has / count, 100.0 * dry / count, 100.0 * sunk / count );
		assert_true( dry < 0.85 * count );
		testCloseTake( &take );
	}
}

// ------------------------------------------------------------------------------------------------- a smooth clip

/// The mannequin's own walk is smoother than a person's: what is a multiple of its own is still less than theirs is on
/// flat ground, but on T03.
static void theMannequinIsSmootherThanPeople( void** state )
{
	(void)state;
	double jerk = 0.0, slide = 0.0;
	static const char* const grounds[] = { "T02", "T11-10", "T11-20", "T11-30", "rubble" };
	for ( int32_t i = 0; i < 5; ++i )
	{
		testBake bake;
		testTake take;
		assert_true( openWalk( 0, grounds[i], &bake, &take ) );
		testBakeTake( &bake, &take );
		print_message( "%-7s mannequin: jerk of the pelvis %5.1f m/s3 (clip %4.1f), slide %4.2f cm/s (%4.2f)\n",
		    grounds[i], take.figures.pelvisJerk, take.flat.pelvisJerk, 100.0 * take.figures.all.slide,
		    100.0 * take.flat.all.slide );
		jerk = fmax( jerk, take.figures.pelvisJerk );
		slide = fmax( slide, take.figures.all.slide );
		testCloseTake( &take );
	}
	for ( int32_t i = 1; i < WALKS; ++i )
	{
		testBake bake;
		testTake take;
		if ( openWalk( i, "T11-10", &bake, &take ) )
		{
			testBakeTake( &bake, &take );
			print_message( "%s on flat ground: jerk %.1f m/s3, slide %.2f cm/s\n", walks[i].name, take.flat.pelvisJerk,
			    100.0 * take.flat.all.slide );
			assert_true( jerk < take.flat.pelvisJerk && slide < take.flat.all.slide );
			testCloseTake( &take );
		}
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( anklesThatBendFurtherKeepSolesDown ),
		cmocka_unit_test( kneesAreAsQuickAsRisersAreHigh ),
		cmocka_unit_test( noSoleLiesFlatOnRubble ),
		cmocka_unit_test( theMannequinIsSmootherThanPeople ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
