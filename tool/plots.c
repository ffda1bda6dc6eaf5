// SPDX-License-Identifier: MIT
// Pictures of a bake. Heights are those of the lowest of the measured sole points over the exact terrain, in
// centimetres; below zero a sole is in the ground. Poses are drawn in the world of the ground.
#include "plots.h"

#include "curves.h"
#include "draw.h"
#include "skin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PLOT_WIDTH 960.0
#define PLOT_HEIGHT 320.0
#define ROW_HEIGHT 300.0
#define MOST_POSES 14

// ---------------------------------------------------------------------------------------------------------- heights

static int32_t toolFindPlanted( const toolBakeResult* result, int32_t leg, toolInterval* intervals )
{
	int32_t count = 0;
	bool open = false;
	for ( int32_t f = 0; f < result->walk.frameCount; ++f )
	{
		bool planted = toolIsPlanted( result, leg, f );
		float time = (float)( (double)f / result->walk.fps );
		if ( planted && open == false )
		{
			intervals[count++].start = time;
		}
		if ( planted )
		{
			intervals[count - 1].end = time;
		}
		open = planted;
	}
	return count;
}

static bool toolWriteSvg( const char* folder, const char* name, toolSvg* svg, toolError* error )
{
	char* path = toolFormat( "%s/%s.svg", folder, name );
	char* text = toolSvgEnd( svg );
	bool good = toolWriteFile( path, text, strlen( text ), error );
	free( text );
	free( path );
	return good;
}

static bool toolPlotLeg( const char* folder, const toolCharacter* character, const soleTerrain* terrain,
    const toolPlotTake* takes, int32_t takeCount, int32_t leg, toolError* error )
{
	int32_t frames = takes[0].result->walk.frameCount;
	float* times = toolAlloc( (size_t)frames, sizeof *times );
	float* heights = toolAlloc( (size_t)frames * (size_t)takeCount, sizeof *heights );
	toolSeries* series = toolAlloc( (size_t)takeCount, sizeof *series );
	toolInterval* planted = toolAlloc( (size_t)frames, sizeof *planted );
	int32_t plantedCount = 0;
	for ( int32_t f = 0; f < frames; ++f )
	{
		times[f] = (float)( (double)f / takes[0].result->walk.fps );
	}
	for ( int32_t t = 0; t < takeCount; ++t )
	{
		const toolBakeResult* result = takes[t].result;
		float* row = heights + (size_t)t * (size_t)frames;
		toolMakeHeightCurve( character, result, terrain, leg, row );
		for ( int32_t f = 0; f < frames; ++f )
		{
			row[f] *= 100.0f; // cm
		}
		series[t] = ( toolSeries ){ .name = takes[t].method, .count = frames, .x = times, .y = row };
		plantedCount = plantedCount > 0 ? plantedCount : toolFindPlanted( result, leg, planted );
	}
	const char* legName = soleRig_GetLeg( character->rig, leg ).name;
	char* title = toolFormat( "Lowest point of the sole over the ground, %s", legName );
	toolSvg* svg = toolSvgBegin( PLOT_WIDTH, PLOT_HEIGHT );
	toolPlot plot = { .box = { 0.0, 0.0, PLOT_WIDTH, PLOT_HEIGHT },
		.title = title,
		.xLabel = "time, s",
		.yLabel = "height, cm",
		.seriesCount = takeCount,
		.series = series,
		.intervalCount = plantedCount,
		.intervals = planted,
		.intervalName = "planted" };
	toolSvgPlot( svg, &plot );
	char* name = toolFormat( "sole_%s", legName );
	for ( char* c = name; *c != 0; ++c )
	{
		bool plain = ( *c >= 'a' && *c <= 'z' ) || ( *c >= 'A' && *c <= 'Z' ) || ( *c >= '0' && *c <= '9' );
		*c = plain || *c == '_' || *c == '-' ? *c : '_';
	}
	bool good = toolWriteSvg( folder, name, svg, error );
	free( name );
	free( title );
	free( planted );
	free( series );
	free( heights );
	free( times );
	return good;
}

// ------------------------------------------------------------------------------------------------------- the picture

/// The character at even distances along its way. Where it stands still there is one.
static void toolAddPoses(
    const toolCharacter* character, const toolBakeResult* result, float spacing, toolTriangles* triangles )
{
	soleVec3 last = { 0.0f, 0.0f, 0.0f };
	int32_t count = 0;
	for ( int32_t f = 0; f < result->walk.frameCount && count < MOST_POSES; ++f )
	{
		soleVec3 place = result->walk.roots[f].translation;
		soleVec3 way = soleSub( place, last );
		if ( count > 0 && way.x * way.x + way.z * way.z < spacing * spacing )
		{
			continue;
		}
		toolSkinModel( character->model, result->output + (size_t)f * (size_t)result->jointCount, result->walk.roots[f],
		    triangles );
		last = place;
		++count;
	}
}

/// A stretch of the way, seen from above.
typedef struct toolStretch
{
	soleVec3 start;
	soleVec3 along; // unit, level
	float length;
	float width; // to either side
} toolStretch;

/// Only the ground along the way: a picture of a whole level would hide the feet.
static void toolAddGround( const toolGroundSource* ground, const toolStretch* stretch, toolTriangles* triangles )
{
	static const float color[3] = { 0.16f, 0.20f, 0.25f };
	const toolGroundMesh* mesh = &ground->mesh;
	soleVec3 aside = soleCross( stretch->along, soleVec( 0.0f, 1.0f, 0.0f ) );
	uint32_t* kept = toolAlloc( (size_t)mesh->triangleCount * 3, sizeof *kept );
	int32_t count = 0;
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		float low[2] = { INFINITY, INFINITY }, high[2] = { -INFINITY, -INFINITY };
		for ( int32_t k = 0; k < 3; ++k )
		{
			const float* p = mesh->positions + 3 * mesh->indices[3 * i + k];
			soleVec3 from = soleSub( soleVec( p[0], p[1], p[2] ), stretch->start );
			const float place[2] = { soleDot( from, stretch->along ), soleDot( from, aside ) };
			for ( int32_t c = 0; c < 2; ++c )
			{
				low[c] = fminf( low[c], place[c] );
				high[c] = fmaxf( high[c], place[c] );
			}
		}
		bool there = high[0] >= -stretch->width && low[0] <= stretch->length + stretch->width &&
		    high[1] >= -stretch->width && low[1] <= stretch->width;
		if ( there )
		{
			memcpy( kept + 3 * count++, mesh->indices + 3 * i, 3 * sizeof *kept );
		}
	}
	toolAddTriangles( triangles, mesh->positions, mesh->vertexCount, kept, count, color );
	free( kept );
}

/// Looks at the way from the side, from a little behind and above; it leads to the right.
static toolSceneView toolLookAtWay( const toolBakeResult* result, float tall )
{
	const toolWalk* walk = &result->walk;
	soleVec3 a = walk->roots[0].translation;
	soleVec3 b = walk->roots[walk->frameCount - 1].translation;
	float low = a.y, high = a.y;
	for ( int32_t f = 0; f < walk->frameCount; ++f )
	{
		low = fminf( low, walk->roots[f].translation.y );
		high = fmaxf( high, walk->roots[f].translation.y );
	}
	soleVec3 up = soleVec( 0.0f, 1.0f, 0.0f );
	soleVec3 way = soleNormalizeOr( soleReject( soleSub( b, a ), up ), soleVec( 0.0f, 0.0f, 1.0f ) );
	soleVec3 aside = soleCross( way, up );
	float wide = soleDistance( a, b ) + 1.4f * tall;
	soleVec3 target = soleLerp( a, b, 0.5f );
	target.y = 0.5f * ( low + high + tall ) - 0.1f * tall;
	soleVec3 eye = soleMulAdd( soleMulAdd( soleMulAdd( target, 10.0f, aside ), 3.2f, up ), -1.6f, way );
	return ( toolSceneView ){ .eye = eye,
		.target = target,
		.up = up,
		.viewHeight = fmaxf( wide * (float)( ROW_HEIGHT / PLOT_WIDTH ), high - low + 1.5f * tall ) };
}

static bool toolDrawPicture( const char* folder, const toolCharacter* character, const toolGroundSource* ground,
    const toolPlotTake* takes, int32_t takeCount, toolError* error )
{
	const toolWalk* walk = &takes[0].result->walk;
	soleVec3 a = walk->roots[0].translation;
	soleVec3 b = walk->roots[walk->frameCount - 1].translation;
	soleVec3 way = soleReject( soleSub( b, a ), soleVec( 0.0f, 1.0f, 0.0f ) );
	float legLength = soleRig_GetLegLength( character->rig, 0 );
	float spacing = soleMaxF( 1.1f * legLength, soleLength( way ) / (float)MOST_POSES );
	toolStretch stretch = { a, soleNormalizeOr( way, soleVec( 0.0f, 0.0f, 1.0f ) ), soleLength( way ),
		0.8f * legLength };
	toolSvg* svg = toolSvgBegin( PLOT_WIDTH, ROW_HEIGHT * (double)takeCount );
	for ( int32_t t = 0; t < takeCount; ++t )
	{
		toolTriangles poses = { 0 };
		toolTriangles land = { 0 };
		toolAddPoses( character, takes[t].result, spacing, &poses );
		toolAddGround( ground, &stretch, &land );
		const toolSceneItem items[] = { { &land, 1.0f, true }, { &poses, 1.0f, false } };
		toolSceneView view = toolLookAtWay( takes[t].result, 2.2f * legLength );
		view.box = ( toolBox ){ 0.0, ROW_HEIGHT * (double)t, PLOT_WIDTH, ROW_HEIGHT };
		view.itemCount = 2;
		view.items = items;
		toolSvgScene( svg, &view );
		toolSvgText( svg, 16.0, ROW_HEIGHT * (double)t + 28.0, 18.0, tool_anchorStart, takes[t].method );
		toolFreeTriangles( &poses );
		toolFreeTriangles( &land );
	}
	return toolWriteSvg( folder, "picture", svg, error );
}

bool toolWritePlots( const char* folder, const toolCharacter* character, const toolGroundSource* ground,
    const soleTerrain* terrain, const toolPlotTake* takes, int32_t takeCount, toolError* error )
{
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( character->rig ); ++leg )
	{
		if ( toolPlotLeg( folder, character, terrain, takes, takeCount, leg, error ) == false )
		{
			return false;
		}
	}
	return character->skinCount == 0 || toolDrawPicture( folder, character, ground, takes, takeCount, error );
}
