// SPDX-License-Identifier: MIT
// Clips bound to a character and sampled: parent-local transforms of every node at a time.
#include "motion.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST_CLIP 3600.0f // s

// ------------------------------------------------------------------------------------------------------- binding

// How much of a name counts when nodes of two files are matched, strictest first.
typedef enum toolNameRule
{
	tool_nameExact,
	tool_nameAnyCase,
	tool_nameWithoutPrefix,
	tool_nameRuleCount
} toolNameRule;

typedef struct toolNameEntry
{
	char* key;
	int32_t node;
} toolNameEntry;

static int toolCompareEntries( const void* a, const void* b )
{
	const toolNameEntry* left = a;
	const toolNameEntry* right = b;
	int order = strcmp( left->key, right->key );
	return order != 0 ? order : ( left->node > right->node ) - ( left->node < right->node );
}

// Bytes up to and including the last ':' or, where there is none, the first '_'. 0: no prefix.
static size_t toolPrefixLength( const char* name )
{
	const char* colon = strrchr( name, ':' );
	const char* mark = colon != NULL ? colon : strchr( name, '_' );
	return mark == NULL || mark[1] == 0 ? 0 : (size_t)( mark - name ) + 1;
}

static int toolCompareStrings( const void* a, const void* b )
{
	return strcmp( *(char* const*)a, *(char* const*)b );
}

// The prefix that more than half of the model's nodes share, or NULL: what is in front of "thigh_l" is no prefix.
static char* toolFindCommonPrefix( const toolModel* model )
{
	char** prefixes = toolAlloc( (size_t)model->nodeCount, sizeof *prefixes );
	size_t count = 0;
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		size_t length = toolPrefixLength( model->nodes[i].name );
		if ( length > 0 )
		{
			prefixes[count++] = toolFormat( "%.*s", (int)length, model->nodes[i].name );
		}
	}
	qsort( prefixes, count, sizeof *prefixes, toolCompareStrings );
	// What more than half share also stands in the middle of them once they are sorted.
	char* middle = count > 0 ? prefixes[count / 2] : NULL;
	size_t same = 0;
	for ( size_t i = 0; i < count; ++i )
	{
		same += strcmp( prefixes[i], middle ) == 0 ? 1 : 0;
	}
	char* common = 2 * same > (size_t)model->nodeCount ? toolCopyString( middle ) : NULL;
	for ( size_t i = 0; i < count; ++i )
	{
		free( prefixes[i] );
	}
	free( prefixes );
	return common;
}

static char* toolMakeKey( const char* name, toolNameRule rule, const char* prefix )
{
	if ( rule == tool_nameWithoutPrefix && prefix != NULL && strncmp( name, prefix, strlen( prefix ) ) == 0 )
	{
		name += strlen( prefix );
	}
	char* key = toolCopyString( name );
	for ( char* c = key; *c != 0 && rule != tool_nameExact; ++c )
	{
		*c = (char)tolower( (unsigned char)*c );
	}
	return key;
}

// Sorted by key; of equal names the first node stands first.
static toolNameEntry* toolMakeNameTable( const toolModel* model, toolNameRule rule, const char* prefix )
{
	toolNameEntry* table = toolAlloc( (size_t)model->nodeCount, sizeof *table );
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		table[i] = ( toolNameEntry ){ toolMakeKey( model->nodes[i].name, rule, prefix ), i };
	}
	qsort( table, (size_t)model->nodeCount, sizeof *table, toolCompareEntries );
	return table;
}

static void toolFreeNameTable( toolNameEntry* table, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		free( table[i].key );
	}
	free( table );
}

static int32_t toolFindEntry( const toolNameEntry* table, int32_t count, const char* key )
{
	int32_t low = 0;
	int32_t high = count;
	while ( low < high )
	{
		int32_t middle = low + ( high - low ) / 2;
		if ( strcmp( table[middle].key, key ) < 0 )
		{
			low = middle + 1;
		}
		else
		{
			high = middle;
		}
	}
	return low < count && strcmp( table[low].key, key ) == 0 ? table[low].node : SOLE_NONE;
}

// Per node of the clip's file the character's node of that name, or SOLE_NONE.
static int32_t* toolMatchNodes( const toolModel* model, const toolModel* clipModel )
{
	int32_t* map = toolAlloc( (size_t)clipModel->nodeCount, sizeof *map );
	char* prefix = toolFindCommonPrefix( model );
	char* clipPrefix = toolFindCommonPrefix( clipModel );
	for ( int32_t i = 0; i < clipModel->nodeCount; ++i )
	{
		map[i] = SOLE_NONE;
	}
	for ( int rule = 0; rule < tool_nameRuleCount; ++rule )
	{
		toolNameEntry* table = toolMakeNameTable( model, (toolNameRule)rule, prefix );
		for ( int32_t i = 0; i < clipModel->nodeCount; ++i )
		{
			if ( map[i] == SOLE_NONE && clipModel->nodes[i].name[0] != 0 )
			{
				char* key = toolMakeKey( clipModel->nodes[i].name, (toolNameRule)rule, clipPrefix );
				map[i] = toolFindEntry( table, model->nodeCount, key );
				free( key );
			}
		}
		toolFreeNameTable( table, model->nodeCount );
	}
	free( prefix );
	free( clipPrefix );
	return map;
}

static bool toolIsLegJoint( const soleRigDef* def, int32_t node )
{
	for ( int32_t i = 0; i < def->legCount; ++i )
	{
		for ( int32_t j = 0; j < def->legs[i].jointCount; ++j )
		{
			if ( def->legs[i].joints[j] == node )
			{
				return true;
			}
		}
	}
	return false;
}

bool toolBindClip(
    const toolCharacter* character, const toolModel* clipModel, int32_t clip, toolBoundClip* bound, toolError* error )
{
	*bound = ( toolBoundClip ){ 0 };
	if ( clip < 0 || clip >= clipModel->clipCount )
	{
		return toolFail( error, "there is no clip %d: the file has %d", clip, clipModel->clipCount );
	}
	const toolClip* source = clipModel->clips + clip;
	float duration = source->end - source->start;
	if ( !( duration <= LONGEST_CLIP ) )
	{
		return toolFail( error, "clip '%s' lasts longer than an hour: cut it into parts", source->name );
	}
	bool same = clipModel == character->model;
	int32_t* map = same ? NULL : toolMatchNodes( character->model, clipModel );
	int32_t legChannels = 0;
	*bound = ( toolBoundClip ){
		.clip = source,
		.nodes = toolAlloc( (size_t)source->channelCount, sizeof *bound->nodes ),
		.duration = duration > 0.0f ? duration : 0.0f,
	};
	for ( int32_t i = 0; i < source->channelCount; ++i )
	{
		int32_t node = source->channels[i].node;
		node = same || node == SOLE_NONE ? node : map[node];
		bound->nodes[i] = node;
		bound->boundCount += node != SOLE_NONE ? 1 : 0;
		legChannels += node != SOLE_NONE && toolIsLegJoint( &character->rigDef, node ) ? 1 : 0;
	}
	free( map );
	if ( legChannels == 0 && same == false )
	{
		toolFail( error,
		    "clip '%s' moves no leg joint of the character, %d of its %d channels were bound: use a clip made for a "
		    "skeleton with the same joint names",
		    source->name, bound->boundCount, source->channelCount );
		toolFreeBoundClip( bound );
		return false;
	}
	return true;
}

void toolBindRest( toolBoundClip* bound )
{
	static const toolClip rest = { .name = TOOL_REST_CLIP, .end = 1.0f };
	*bound = ( toolBoundClip ){ .clip = &rest, .nodes = toolAlloc( 1, sizeof *bound->nodes ), .duration = rest.end };
}

void toolFreeBoundClip( toolBoundClip* bound )
{
	free( bound->nodes );
	*bound = ( toolBoundClip ){ 0 };
}

// ------------------------------------------------------------------------------------------------------ sampling

// Along the great circle on the near side; the chord where both are close.
static soleQuat toolSlerp( soleQuat a, soleQuat b, float t )
{
	double cosine = (double)soleDotQuat( a, b );
	if ( cosine < 0.0 )
	{
		b = soleNegQuat( b );
		cosine = -cosine;
	}
	if ( cosine > 0.9995 )
	{
		return soleNlerp( a, b, t );
	}
	double angle = acos( cosine );
	float wa = (float)( sin( angle * ( 1.0 - (double)t ) ) / sin( angle ) );
	float wb = (float)( sin( angle * (double)t ) / sin( angle ) );
	soleQuat q = { wa * a.x + wb * b.x, wa * a.y + wb * b.y, wa * a.z + wb * b.z, wa * a.w + wb * b.w };
	return soleNormalizeQuat( q );
}

// Index of the last key at or before time; 0 where there is none.
static int32_t toolFindKey( const toolChannel* channel, float time )
{
	int32_t low = 0;
	int32_t high = channel->keyCount;
	while ( low + 1 < high )
	{
		int32_t middle = low + ( high - low ) / 2;
		if ( channel->times[middle] <= time )
		{
			low = middle;
		}
		else
		{
			high = middle;
		}
	}
	return low;
}

// The value of a key itself, which in cubic channels stands between its tangents.
static const float* toolKeyValue( const toolChannel* channel, int32_t key, int width )
{
	bool cubic = channel->interpolation == tool_cubic;
	return channel->values + ( cubic ? ( 3 * (size_t)key + 1 ) : (size_t)key ) * (size_t)width;
}

// Hermite spline between two keys, tangents per second, as glTF defines it.
static void toolSampleCubic( const toolChannel* channel, int32_t key, int width, float t, float span, float* value )
{
	const float* v0 = toolKeyValue( channel, key, width );
	const float* v1 = toolKeyValue( channel, key + 1, width );
	const float* out = v0 + width;
	const float* in = v1 - width;
	float t2 = t * t;
	float t3 = t2 * t;
	for ( int i = 0; i < width; ++i )
	{
		value[i] = ( 2.0f * t3 - 3.0f * t2 + 1.0f ) * v0[i] + ( t3 - 2.0f * t2 + t ) * span * out[i] +
		    ( 3.0f * t2 - 2.0f * t3 ) * v1[i] + ( t3 - t2 ) * span * in[i];
	}
}

static soleQuat toolLoadQuat( const float* v )
{
	soleQuat q = { v[0], v[1], v[2], v[3] };
	return soleNormalizeQuat( q );
}

static void toolSampleValue( const toolChannel* channel, float time, int width, float value[4] )
{
	int32_t key = toolFindKey( channel, time );
	const float* v0 = toolKeyValue( channel, key, width );
	memcpy( value, v0, (size_t)width * sizeof *value );
	bool between = key + 1 < channel->keyCount && time > channel->times[key];
	float span = between ? channel->times[key + 1] - channel->times[key] : 0.0f;
	if ( channel->interpolation == tool_step || !( span > 0.0f ) )
	{
		return;
	}
	float t = soleClampF( ( time - channel->times[key] ) / span, 0.0f, 1.0f );
	const float* v1 = toolKeyValue( channel, key + 1, width );
	if ( channel->interpolation == tool_cubic )
	{
		toolSampleCubic( channel, key, width, t, span, value );
	}
	else if ( width == 4 )
	{
		soleQuat q = toolSlerp( toolLoadQuat( v0 ), toolLoadQuat( v1 ), t );
		memcpy( value, ( float[4] ){ q.x, q.y, q.z, q.w }, 4 * sizeof *value );
	}
	else
	{
		for ( int i = 0; i < 3; ++i )
		{
			value[i] = v0[i] + t * ( v1[i] - v0[i] );
		}
	}
}

void toolSampleChannel( const toolChannel* channel, float fileTime, float value[4] )
{
	bool rotation = channel->path == tool_pathRotation;
	toolSampleValue( channel, fileTime, rotation ? 4 : 3, value );
	if ( rotation )
	{
		soleQuat q = toolLoadQuat( value );
		memcpy( value, ( float[4] ){ q.x, q.y, q.z, q.w }, 4 * sizeof *value );
	}
}

static float toolGetScale( const toolCharacter* character, int32_t node )
{
	bool scaled = character->parents[node] == SOLE_NONE && character->scale > 0.0f;
	return scaled ? character->scale : 1.0f;
}

static soleTransform toolRestLocal( const toolCharacter* character, int32_t node )
{
	float scale = toolGetScale( character, node );
	soleTransform local = character->model->nodes[node].local;
	local.translation = soleScale( scale, local.translation );
	local.scale = soleScale( scale, local.scale );
	return local;
}

static void toolApplyChannel( const toolChannel* channel, float fileTime, float scale, soleTransform* local )
{
	float value[4];
	toolSampleChannel( channel, fileTime, value );
	switch ( channel->path )
	{
	case tool_pathTranslation:
		local->translation = soleScale( scale, soleVec( value[0], value[1], value[2] ) );
		break;
	case tool_pathRotation:
		local->rotation = toolLoadQuat( value );
		break;
	case tool_pathScale:
		local->scale = soleScale( scale, soleVec( value[0], value[1], value[2] ) );
		break;
	}
}

void toolGetRestPose( const toolCharacter* character, soleTransform* pose )
{
	for ( int32_t i = 0; i < character->jointCount; ++i )
	{
		pose[i] = toolRestLocal( character, i );
	}
}

void toolSampleClip( const toolCharacter* character, const toolBoundClip* bound, float time, soleTransform* pose )
{
	toolGetRestPose( character, pose );
	float fileTime = bound->clip->start + ( time > 0.0f ? time : 0.0f );
	for ( int32_t i = 0; i < bound->clip->channelCount; ++i )
	{
		const toolChannel* channel = bound->clip->channels + i;
		int32_t node = bound->nodes[i];
		if ( node != SOLE_NONE && channel->keyCount > 0 )
		{
			toolApplyChannel( channel, fileTime, toolGetScale( character, node ), pose + node );
		}
	}
}

soleTransform toolSampleNode( const toolCharacter* character, const toolBoundClip* bound, float time, int32_t node )
{
	float fileTime = bound->clip->start + ( time > 0.0f ? time : 0.0f );
	soleTransform world = soleTransform_Identity();
	for ( int32_t i = node; i != SOLE_NONE; i = character->parents[i] )
	{
		soleTransform local = toolRestLocal( character, i );
		for ( int32_t j = 0; j < bound->clip->channelCount; ++j )
		{
			if ( bound->nodes[j] == i && bound->clip->channels[j].keyCount > 0 )
			{
				toolApplyChannel( bound->clip->channels + j, fileTime, toolGetScale( character, i ), &local );
			}
		}
		world = soleMulTransform( local, world );
	}
	return world;
}

// --------------------------------------------------------------------------------------------------------- poses

soleTransform toolPoseWorld( const toolCharacter* character, const soleTransform* pose, int32_t node )
{
	soleTransform world = pose[node];
	for ( int32_t i = character->parents[node]; i != SOLE_NONE; i = character->parents[i] )
	{
		world = soleMulTransform( pose[i], world );
	}
	return world;
}

void toolMovePose( const toolCharacter* character, soleTransform* pose, int32_t node, soleTransform motion )
{
	int32_t parent = character->parents[node];
	soleTransform base = parent != SOLE_NONE ? toolPoseWorld( character, pose, parent ) : soleTransform_Identity();
	soleVec3 moved = soleTransformPoint( motion, soleTransformPoint( base, pose[node].translation ) );
	soleQuat turn = soleMulQuat( soleConjugate( base.rotation ), soleMulQuat( motion.rotation, base.rotation ) );
	pose[node].translation = soleInvTransformPoint( base, moved );
	pose[node].rotation = soleNormalizeQuat( soleMulQuat( turn, pose[node].rotation ) );
	pose[node].scale = soleMul( motion.scale, pose[node].scale );
}
