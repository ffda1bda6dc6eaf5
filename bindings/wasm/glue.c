// SPDX-License-Identifier: MIT
// The library as JavaScript calls it: characters whose arrays lie in the module's memory, and drawing as a list. All
// else is the library's own functions, exported as they are.
#include "glue.h"

#include <stdlib.h>
#include <string.h>

// ------------------------------------------------------------------------------------------------------ characters

static void* soleTakeRoom( char** at, size_t count, size_t size )
{
	void* room = *at;
	*at += count * size;
	return room;
}

/// Lays the arrays of a character behind it. All of them are of four-byte alignment. @return the end
static char* soleLayOut( soleWasmCharacter* c, size_t joints, size_t legs )
{
	char* at = (char*)( c + 1 );
	c->pose = soleTakeRoom( &at, joints, sizeof *c->pose );
	c->secondPose = soleTakeRoom( &at, joints, sizeof *c->secondPose );
	c->placed = soleTakeRoom( &at, joints, sizeof *c->placed );
	c->legWeight = soleTakeRoom( &at, legs, sizeof *c->legWeight );
	c->positionWeight = soleTakeRoom( &at, legs, sizeof *c->positionWeight );
	c->rotationWeight = soleTakeRoom( &at, legs, sizeof *c->rotationWeight );
	c->contact = soleTakeRoom( &at, legs, sizeof *c->contact );
	c->steps = soleTakeRoom( &at, legs, sizeof *c->steps );
	c->supports = soleTakeRoom( &at, (size_t)c->supportCapacity, sizeof *c->supports );
	c->probes = soleTakeRoom( &at, (size_t)c->probeCapacity, sizeof *c->probes );
	c->hits = soleTakeRoom( &at, (size_t)c->probeCapacity, sizeof *c->hits );
	return at;
}

/// A frame that says nothing beyond the pose.
static void soleFillCharacter( soleWasmCharacter* c )
{
	c->frame.pose = c->pose;
	c->frame.root = soleTransform_Identity();
	c->frame.weight = 1.0f;
	c->frame.legWeight = c->legWeight;
	c->frame.positionWeight = c->positionWeight;
	c->frame.rotationWeight = c->rotationWeight;
	c->frame.contact = c->contact;
	c->frame.steps = c->steps;
	c->frame.supports = c->supports;
	c->state = soleDefaultState( c->rig );
	c->before = c->state;
	for ( int32_t i = 0; i < soleRig_GetJointCount( c->rig ); ++i )
	{
		c->pose[i] = c->secondPose[i] = c->placed[i] = soleTransform_Identity();
	}
	for ( int32_t i = 0; i < soleRig_GetLegCount( c->rig ); ++i )
	{
		c->legWeight[i] = c->positionWeight[i] = c->rotationWeight[i] = 1.0f;
		c->contact[i] = ( soleContactInput ){ -1.0f, -1.0f };
		c->steps[i] = ( soleStepInput ){ .since = -1.0f, .until = -1.0f };
	}
}

soleWasmCharacter* soleWasm_CreateCharacter( const soleRig* rig, int32_t supportCapacity )
{
	size_t joints = (size_t)soleRig_GetJointCount( rig );
	size_t legs = (size_t)soleRig_GetLegCount( rig );
	// Laid out once to see how much room it takes.
	soleWasmCharacter probe = { .probeCapacity = (int32_t)legs * SOLE_MAX_PROBES_PER_LEG,
		.supportCapacity = supportCapacity };
	size_t byteCount = (size_t)( soleLayOut( &probe, joints, legs ) - (char*)&probe );
	soleWasmCharacter* character = calloc( 1, byteCount );
	if ( character == NULL )
	{
		return NULL;
	}
	*character = probe;
	soleLayOut( character, joints, legs );
	character->rig = rig;
	soleFillCharacter( character );
	return character;
}

int32_t soleWasm_Gather( soleWasmCharacter* c )
{
	c->probeCount = soleGatherProbes( c->rig, c->settings, &c->state, &c->frame, c->probes, c->probeCapacity );
	// Probes that nobody answers have met nothing.
	memset( c->hits, 0, (size_t)c->probeCount * sizeof *c->hits );
	for ( int32_t i = 0; i < c->probeCount; ++i )
	{
		c->hits[i].surface = SOLE_NONE;
		c->hits[i].asked_w = c->probes[i].start_w;
	}
	return c->probeCount;
}

void soleWasm_CastGround( soleWasmCharacter* c, const soleGround* ground )
{
	soleCastProbes( ground, c->probes, c->probeCount, c->hits );
}

void soleWasm_CastPieces( soleWasmCharacter* c, const soleGroundPiece* pieces, int32_t count )
{
	for ( int32_t i = 0; i < c->probeCount; ++i )
	{
		c->hits[i] = soleCastPieces( pieces, count, c->probes + i );
	}
}

void soleWasm_Solve( soleWasmCharacter* c )
{
	size_t joints = (size_t)soleRig_GetJointCount( c->rig );
	memcpy( &c->before, &c->state, soleState_GetByteCount( c->rig ) );
	soleSolve( c->rig, c->settings, &c->state, &c->frame, c->hits, c->probeCount, &c->output );
	memcpy( c->placed, c->pose, joints * sizeof *c->placed );
	if ( c->frame.secondPose != NULL )
	{
		soleBlendSecondPose( c->rig, &c->output, c->frame.secondPose, c->placed );
	}
	soleApply( c->rig, &c->output, c->placed );
}

// --------------------------------------------------------------------------------------------------------- drawing

static soleWasmMark* soleAddMark( void* user, soleWasmMarkKind kind, soleVec3 a_w, uint32_t color, uint32_t category )
{
	static soleWasmMark surplus;
	soleWasmMarks* list = user;
	soleWasmMark* mark = list->count < list->capacity ? list->marks + list->count : &surplus;
	list->count += 1;
	*mark = ( soleWasmMark ){ .kind = kind, .color = color, .category = category, .a_w = a_w };
	return mark;
}

static void soleMarkLine( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user )
{
	soleAddMark( user, sole_markLine, from_w, color, category )->b_w = to_w;
}

static void soleMarkArrow( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user )
{
	soleAddMark( user, sole_markArrow, from_w, color, category )->b_w = to_w;
}

static void soleMarkCircle(
    soleVec3 center_w, soleVec3 normal_w, float radius, uint32_t color, uint32_t category, void* user )
{
	soleWasmMark* mark = soleAddMark( user, sole_markCircle, center_w, color, category );
	mark->b_w = normal_w;
	mark->radius = radius;
}

static void soleMarkSphere( soleVec3 center_w, float radius, uint32_t color, uint32_t category, void* user )
{
	soleAddMark( user, sole_markSphere, center_w, color, category )->radius = radius;
}

static void soleMarkText( soleVec3 place_w, const char* text, uint32_t color, uint32_t category, void* user )
{
	soleWasmMark* mark = soleAddMark( user, sole_markText, place_w, color, category );
	strncpy( mark->text, text, sizeof mark->text - 1 );
}

soleDebugDraw soleWasm_MakePen( soleWasmMarks* list, uint32_t mask )
{
	soleDebugDraw draw = soleDefaultDebugDraw();
	draw.line = soleMarkLine;
	draw.arrow = soleMarkArrow;
	draw.circle = soleMarkCircle;
	draw.sphere = soleMarkSphere;
	draw.text = soleMarkText;
	draw.user = list;
	draw.mask = mask;
	return draw;
}

int32_t soleWasm_Draw( const soleWasmCharacter* character, uint32_t mask, soleWasmMark* marks, int32_t capacity )
{
	soleWasmMarks list = { .marks = marks, .capacity = capacity };
	soleDebugDraw draw = soleWasm_MakePen( &list, mask );
	soleDrawnFrame drawn = {
		.rig = character->rig,
		.settings = character->settings,
		.state = &character->before,
		.frame = &character->frame,
		.probes = character->probes,
		.hits = character->hits,
		.probeCount = character->probeCount,
		.hitCount = character->probeCount,
	};
	soleDrawFrame( &draw, &drawn );
	return list.count;
}
