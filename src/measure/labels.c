// SPDX-License-Identifier: MIT
// Which parts of which feet a clip means to have on the floor, from heights and speeds of heel and ball over a flat
// floor; and what has to be known first: where that floor is, and how fast an in-place clip pretends to walk.
// The floor as the median of the lowest cluster of slow points: Rempe et al., HuMoR, ICCV 2021.
#include "base/core.h"
#include "measure/pose.h"

#include <math.h>
#include <stdlib.h>

#define SLOW 0.167           // L/s: a sole point that rises or sinks slower may stand: 0.15 m/s of a leg of 0.9 m
#define CLUSTER 0.022        // L: 2 cm of the same, the thickness of a cluster of heights
#define CLUSTER_SEARCH 0.045 // L: how far over the lowest heights the floor may be
#define STANDING 0.05        // L/s: a clip that strides slower than this stands
#define SPEED_SHARE 0.1      // of the character's own speed, below which a point counts as still
#define SPEED_WINDOW 0.25    // s to either side, over which that speed is taken

enum
{
	sole_trackHeel,
	sole_trackBall,
	sole_trackTip, // of the toes: only asked where a clip stands on them alone
	sole_trackCount
};

/// Sole points and pelvis of all frames.
typedef struct soleTracks
{
	int32_t frameCount;
	int32_t legCount;
	double rate;
	double legLength; // longest, in the space of the tracks
	soleVec3d up;
	soleVec3d* points; // frame, leg, heel, ball or tip of the toes
	soleVec3d* pelvis; // frame
} soleTracks;

static void soleFreeTracks( const soleAllocator* allocator, soleTracks* tracks )
{
	size_t frames = (size_t)tracks->frameCount;
	size_t perFrame = (size_t)tracks->legCount * sole_trackCount;
	soleFree( allocator, tracks->points, frames * perFrame * sizeof *tracks->points );
	soleFree( allocator, tracks->pelvis, frames * sizeof *tracks->pelvis );
}

static soleVec3d* soleTrackPoint( const soleTracks* tracks, int32_t frame, int32_t leg, int32_t track )
{
	size_t index = (size_t)frame * (size_t)tracks->legCount + (size_t)leg;
	return tracks->points + index * sole_trackCount + (size_t)track;
}

/// @param world false: in character space, as if no frame had a root.
static bool soleMakeTracks( const soleMotion* motion, bool world, const soleAllocator* allocator, soleTracks* tracks )
{
	const soleRig* rig = motion->rig;
	double scale = world ? fabs( (double)motion->roots[0].scale.x ) : 1.0;
	*tracks = ( soleTracks ){
		.frameCount = motion->frameCount,
		.legCount = soleRig_GetLegCount( rig ),
		.rate = (double)motion->frameRate,
		.up = soleUnitD( soleWiden( world ? motion->up : soleRig_GetUp( rig ) ), ( soleVec3d ){ 0.0, 1.0, 0.0 } ),
	};
	size_t frames = (size_t)tracks->frameCount;
	size_t perFrame = (size_t)tracks->legCount * sole_trackCount;
	soleMeasurePose pose;
	tracks->points = soleAlloc( allocator, frames * perFrame * sizeof *tracks->points );
	tracks->pelvis = soleAlloc( allocator, frames * sizeof *tracks->pelvis );
	if ( tracks->points == NULL || tracks->pelvis == NULL || soleMakeMeasurePose( rig, allocator, &pose ) == false )
	{
		soleFreeTracks( allocator, tracks );
		return false;
	}
	for ( int32_t leg = 0; leg < tracks->legCount; ++leg )
	{
		tracks->legLength = fmax( tracks->legLength, scale * (double)soleRig_GetLegLength( rig, leg ) );
	}
	for ( int32_t frame = 0; frame < tracks->frameCount; ++frame )
	{
		if ( world )
		{
			soleEvaluateWorld( &pose, motion, frame );
		}
		else
		{
			soleEvaluateCharacter( &pose, motion, frame );
		}
		tracks->pelvis[frame] = pose.joints[soleRig_GetPelvis( rig )].translation;
		for ( int32_t leg = 0; leg < tracks->legCount; ++leg )
		{
			*soleTrackPoint( tracks, frame, leg, sole_trackHeel ) =
			    soleGetCarried( &pose, soleGetHeelPoint( rig, leg ) );
			*soleTrackPoint( tracks, frame, leg, sole_trackBall ) =
			    soleGetCarried( &pose, soleGetBallPoint( rig, leg ) );
			*soleTrackPoint( tracks, frame, leg, sole_trackTip ) = soleGetCarried( &pose, soleGetTipPoint( rig, leg ) );
		}
	}
	soleFreeMeasurePose( allocator, &pose );
	return true;
}

/// Central difference; one-sided in the first and the last frame.
static soleVec3d soleTrackVelocity( const soleTracks* tracks, int32_t frame, int32_t leg, int32_t track )
{
	int32_t before = frame > 0 ? frame - 1 : frame;
	int32_t after = frame + 1 < tracks->frameCount ? frame + 1 : frame;
	soleVec3d step =
	    soleSubD( *soleTrackPoint( tracks, after, leg, track ), *soleTrackPoint( tracks, before, leg, track ) );
	return after > before ? soleScaleD( tracks->rate / (double)( after - before ), step ) : step;
}

static int soleCompareDoubles( const void* a, const void* b )
{
	double x = *(const double*)a;
	double y = *(const double*)b;
	return ( x > y ) - ( x < y );
}

// ---------------------------------------------------------------------------------------------------------- floor

/// Median of the densest cluster that begins near the lowest heights. Sorts them.
static double soleFindLowestCluster( double* heights, int32_t count, double legLength )
{
	qsort( heights, (size_t)count, sizeof *heights, soleCompareDoubles );
	// A few points below the floor, as a clip has them where a toe sinks in, are not the floor.
	double lowest = heights[count / 50];
	int32_t best = 0;
	int32_t bestEnd = 0;
	int32_t end = 0;
	for ( int32_t first = 0; first < count && heights[first] <= lowest + CLUSTER_SEARCH * legLength; ++first )
	{
		while ( end < count && heights[end] <= heights[first] + CLUSTER * legLength )
		{
			++end;
		}
		if ( end - first > bestEnd - best )
		{
			best = first;
			bestEnd = end;
		}
	}
	return heights[best + ( bestEnd - best ) / 2];
}

/// Slow along up. How fast an in-place clip's feet go along the floor is not known yet; but the faster they go, the
/// less still they stand.
static bool soleIsLevel( const soleTracks* tracks, soleVec3d velocity )
{
	double climb = fabs( soleDotD( velocity, tracks->up ) );
	double along = soleLengthD( soleRejectD( velocity, tracks->up ) );
	return climb < fmax( SLOW * tracks->legLength, SPEED_SHARE * along );
}

/// Of the tracks from first to last.
static int32_t soleGatherHeights(
    const soleTracks* tracks, int32_t firstTrack, int32_t lastTrack, bool onlyLevel, double* heights )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < tracks->frameCount * tracks->legCount * sole_trackCount; ++i )
	{
		int32_t track = i % sole_trackCount;
		int32_t leg = i / sole_trackCount % tracks->legCount;
		int32_t frame = i / sole_trackCount / tracks->legCount;
		double height = soleDotD( tracks->points[i], tracks->up );
		// What is not finite fails the comparisons.
		bool level = onlyLevel == false || soleIsLevel( tracks, soleTrackVelocity( tracks, frame, leg, track ) );
		if ( track >= firstTrack && track <= lastTrack && level && fabs( height ) < HUGE_VAL )
		{
			heights[count++] = height;
		}
	}
	return count;
}

/// Of tracks in character space.
static bool soleFindFloor( const soleTracks* tracks, double* floor )
{
	*floor = 0.0;
	size_t capacity = (size_t)tracks->frameCount * (size_t)tracks->legCount * sole_trackCount;
	double* heights = soleAlloc( NULL, capacity * sizeof *heights );
	if ( heights == NULL )
	{
		return false;
	}
	int32_t count = soleGatherHeights( tracks, sole_trackHeel, sole_trackBall, true, heights );
	// A clip in which nothing ever stands still is on the floor where it is lowest.
	count = count > 0 ? count : soleGatherHeights( tracks, sole_trackHeel, sole_trackBall, false, heights );
	if ( count > 0 )
	{
		*floor = soleFindLowestCluster( heights, count, tracks->legLength );
	}
	// Where the tips of the toes are mostly lower than that, the clip goes on tiptoe.
	int32_t tips = soleGatherHeights( tracks, sole_trackTip, sole_trackTip, false, heights );
	if ( count > 0 && tips > 0 )
	{
		qsort( heights, (size_t)tips, sizeof *heights, soleCompareDoubles );
		bool tiptoe = heights[tips / 2] < *floor - CLUSTER * tracks->legLength;
		*floor = tiptoe ? soleFindLowestCluster( heights, tips, tracks->legLength ) : *floor;
	}
	soleFree( NULL, heights, capacity * sizeof *heights );
	return count > 0;
}

float soleFindClipFloor( const soleMotion* motion )
{
	soleTracks tracks;
	bool valid = soleCheckMotion( motion, "motion", NULL ) == sole_success;
	SOLE_ASSERT( valid && "motion: give rig, frames, frame rate and up" );
	if ( valid == false || soleMakeTracks( motion, false, NULL, &tracks ) == false )
	{
		return 0.0f;
	}
	double floor = 0.0;
	soleFindFloor( &tracks, &floor );
	soleFreeTracks( NULL, &tracks );
	return (float)floor;
}

// --------------------------------------------------------------------------------------------------------- stride

/// Horizontal velocities of the sole points of legs [first, end) that stand, by height and by speed along up.
static int32_t soleFindStanceVelocities(
    const soleTracks* tracks, double floor, int32_t first, int32_t end, soleVec3d* velocities )
{
	int32_t count = 0;
	for ( int32_t frame = 1; frame + 1 < tracks->frameCount; ++frame )
	{
		for ( int32_t leg = first; leg < end; ++leg )
		{
			double heel = soleDotD( *soleTrackPoint( tracks, frame, leg, sole_trackHeel ), tracks->up );
			double ball = soleDotD( *soleTrackPoint( tracks, frame, leg, sole_trackBall ), tracks->up );
			int32_t track = heel < ball ? sole_trackHeel : sole_trackBall;
			soleVec3d velocity = soleTrackVelocity( tracks, frame, leg, track );
			if ( fmin( heel, ball ) - floor < CLUSTER * tracks->legLength && soleIsLevel( tracks, velocity ) )
			{
				velocities[count++] = soleRejectD( velocity, tracks->up );
			}
		}
	}
	return count;
}

/// Of all velocities no further than radius from a centre the one that is nearest to all others, by the sum of
/// distances; the centre where there is none. Looks at no more than some hundred of them.
/// @return how many of those it looked at were near enough
static int32_t soleFindMiddle( const soleVec3d* velocities, int32_t count, double radius, soleVec3d* center )
{
	int32_t step = count / 400 + 1;
	double least = HUGE_VAL;
	soleVec3d from = *center;
	int32_t within = 0;
	for ( int32_t i = 0; i < count; i += step )
	{
		if ( soleLengthD( soleSubD( velocities[i], from ) ) > radius )
		{
			continue;
		}
		++within;
		double sum = 0.0;
		for ( int32_t k = 0; k < count; k += step )
		{
			bool counts = soleLengthD( soleSubD( velocities[k], from ) ) <= radius;
			sum += counts ? soleLengthD( soleSubD( velocities[k], velocities[i] ) ) : 0.0;
		}
		if ( sum < least )
		{
			least = sum;
			*center = velocities[i];
		}
	}
	return within;
}

/// How far from the usual stance velocity one may be: further is a foot that swings low over the floor.
static double soleStanceRadius( const soleTracks* tracks, soleVec3d velocity )
{
	return fmax( SLOW * tracks->legLength, 0.3 * soleLengthD( velocity ) );
}

/// First what is usual for all legs, then the mean over the legs of what is usual for each: feet that do not keep the
/// same pace then slide alike.
static soleVec3d soleFindStanceVelocity( const soleTracks* tracks, double floor, soleVec3d* velocities )
{
	soleVec3d usual = { 0.0, 0.0, 0.0 };
	int32_t count = soleFindStanceVelocities( tracks, floor, 0, tracks->legCount, velocities );
	soleFindMiddle( velocities, count, HUGE_VAL, &usual );
	soleFindMiddle( velocities, count, soleStanceRadius( tracks, usual ), &usual );
	soleVec3d sum = { 0.0, 0.0, 0.0 };
	double weights = 0.0;
	for ( int32_t leg = 0; leg < tracks->legCount; ++leg )
	{
		soleVec3d own = usual;
		count = soleFindStanceVelocities( tracks, floor, leg, leg + 1, velocities );
		double weight = (double)soleFindMiddle( velocities, count, soleStanceRadius( tracks, usual ), &own );
		sum = soleAddD( sum, soleScaleD( weight, own ) );
		weights += weight;
	}
	return weights > 0.0 ? soleScaleD( 1.0 / weights, sum ) : usual;
}

soleVec3 soleFindStrideVelocity( const soleMotion* motion )
{
	soleVec3 none = { 0.0f, 0.0f, 0.0f };
	soleTracks tracks;
	bool valid = soleCheckMotion( motion, "motion", NULL ) == sole_success;
	SOLE_ASSERT( valid && "motion: give rig, frames, frame rate and up" );
	if ( valid == false || soleMakeTracks( motion, false, NULL, &tracks ) == false )
	{
		return none;
	}
	double floor = 0.0;
	soleVec3d stance = { 0.0, 0.0, 0.0 };
	size_t byteCount = (size_t)tracks.frameCount * (size_t)tracks.legCount * sizeof stance;
	soleVec3d* velocities = soleAlloc( NULL, byteCount );
	if ( velocities != NULL && soleFindFloor( &tracks, &floor ) )
	{
		stance = soleFindStanceVelocity( &tracks, floor, velocities );
	}
	soleFree( NULL, velocities, byteCount );
	soleFreeTracks( NULL, &tracks );
	if ( soleLengthD( stance ) < STANDING * tracks.legLength )
	{
		return none;
	}
	return soleVec( (float)-stance.x, (float)-stance.y, (float)-stance.z );
}

// --------------------------------------------------------------------------------------------------------- labels

soleLabelDef soleDefaultLabelDef( void )
{
	return ( soleLabelDef ){
		.speedOn = 0.15f,
		.speedOff = 0.30f,
		.heightOn = 0.02f,
		.heightOff = 0.04f,
		.minimum = 0.05f,
		.internalValue = SOLE_COOKIE,
	};
}

static bool soleLabelDef_IsUsable( const soleLabelDef* def )
{
	return def != NULL && def->internalValue == SOLE_COOKIE && def->speedOn > 0.0f && def->speedOff >= def->speedOn &&
	    soleIsFinite( def->speedOff ) && soleIsFinite( def->heightOn ) && def->heightOff >= def->heightOn &&
	    soleIsFinite( def->heightOff ) && def->minimum >= 0.0f && soleIsFinite( def->minimum );
}

/// How fast the body travels along the floor, over a window that a single step's sway does not fill.
static double soleTravelSpeed( const soleTracks* tracks, int32_t frame )
{
	int32_t half = (int32_t)( SPEED_WINDOW * tracks->rate + 0.5 );
	int32_t before = frame - half > 0 ? frame - half : 0;
	int32_t after = frame + half < tracks->frameCount ? frame + half : tracks->frameCount - 1;
	if ( after <= before )
	{
		return 0.0;
	}
	soleVec3d way = soleRejectD( soleSubD( tracks->pelvis[after], tracks->pelvis[before] ), tracks->up );
	return soleLengthD( way ) * tracks->rate / (double)( after - before );
}

/// Sets one bit of one leg's labels where its point is down.
static void soleMarkContacts( const soleTracks* tracks, const soleLabelDef* def, double floor, int32_t leg,
    int32_t track, uint8_t bit, uint8_t* labels )
{
	bool on = false;
	for ( int32_t frame = 0; frame < tracks->frameCount; ++frame )
	{
		double height = soleDotD( *soleTrackPoint( tracks, frame, leg, track ), tracks->up ) - floor;
		double speed = soleLengthD( soleTrackVelocity( tracks, frame, leg, track ) );
		double raised = fmax( 1.0, SPEED_SHARE * soleTravelSpeed( tracks, frame ) / (double)def->speedOn );
		double speedLimit = raised * (double)( on ? def->speedOff : def->speedOn );
		double heightLimit = (double)( on ? def->heightOff : def->heightOn );
		// What is not finite is not down.
		on = speed < speedLimit && height < heightLimit;
		if ( on )
		{
			labels[(size_t)frame * (size_t)tracks->legCount + (size_t)leg] |= bit;
		}
	}
}

/// Turns over runs of a bit's value that are too short. Runs cut off by an end of the motion are left: how long they
/// are isn't known.
static void soleDropShortRuns(
    const soleTracks* tracks, double minimum, int32_t leg, uint8_t bit, bool value, uint8_t* labels )
{
	size_t stride = (size_t)tracks->legCount;
	uint8_t* at = labels + leg;
	int32_t first = 0;
	for ( int32_t frame = 1; frame <= tracks->frameCount; ++frame )
	{
		bool before = ( at[stride * (size_t)( frame - 1 )] & bit ) != 0;
		if ( frame < tracks->frameCount && ( ( at[stride * (size_t)frame] & bit ) != 0 ) == before )
		{
			continue;
		}
		bool shorter = (double)( frame - first ) < minimum * tracks->rate - 1e-3;
		if ( before == value && shorter && first > 0 && frame < tracks->frameCount )
		{
			for ( int32_t i = first; i < frame; ++i )
			{
				at[stride * (size_t)i] ^= bit;
			}
		}
		first = frame;
	}
}

soleResult soleLabelContacts(
    const soleMotion* motion, const soleLabelDef* def, const soleAllocator* allocator, uint8_t* labels )
{
	soleResult result = soleCheckMotion( motion, "motion", NULL );
	bool usable = result == sole_success && soleLabelDef_IsUsable( def ) && labels != NULL;
	SOLE_ASSERT( usable && "start from soleDefaultLabelDef(); motion needs rig, frames, frame rate and up" );
	soleTracks tracks;
	if ( usable == false )
	{
		return sole_invalidDefinition;
	}
	if ( soleMakeTracks( motion, true, allocator, &tracks ) == false )
	{
		return sole_outOfMemory;
	}
	// The floor is flat, so it is where the first frame has it.
	soleTransform root = motion->roots[0];
	double floor =
	    soleDotD( soleWiden( root.translation ), tracks.up ) + fabs( (double)root.scale.x ) * (double)motion->clipFloor;
	for ( int32_t i = 0; i < tracks.frameCount * tracks.legCount; ++i )
	{
		labels[i] = sole_labelNone;
	}
	for ( int32_t leg = 0; leg < tracks.legCount; ++leg )
	{
		for ( int32_t track = 0; track <= sole_trackBall; ++track )
		{
			uint8_t bit = track == sole_trackHeel ? sole_labelHeel : sole_labelToe;
			soleMarkContacts( &tracks, def, floor, leg, track, bit, labels );
			soleDropShortRuns( &tracks, (double)def->minimum, leg, bit, true, labels );
			soleDropShortRuns( &tracks, (double)def->minimum, leg, bit, false, labels );
		}
	}
	soleFreeTracks( allocator, &tracks );
	return sole_success;
}
