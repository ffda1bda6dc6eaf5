// SPDX-License-Identifier: MIT
// A take as a clip for the character's own file. All values are parent-local in the file's units: the character's scale
// goes into the node that carries the travel, whose track is such that its transform in the scene is root * in-place.
#include "bake.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SEAM 1e-3 // s; the longest time in which a round that does not end as it began goes over into the next

typedef struct toolClipMaker
{
	const toolCharacter* character;
	const toolBoundClip* bound;
	const toolTravel* travel;
	const toolBakeResult* result;
	bool* keyed; // per node: gets a key a frame
	toolClip* clip;
	int32_t capacity;
} toolClipMaker;

static toolChannel* toolAddChannel(
    toolClipMaker* maker, int32_t node, toolPath path, toolInterpolation interpolation, size_t keyCount )
{
	toolClip* clip = maker->clip;
	if ( clip->channelCount == maker->capacity )
	{
		maker->capacity = 2 * maker->capacity + 64;
		clip->channels = toolGrow( clip->channels, (size_t)maker->capacity, sizeof *clip->channels );
	}
	toolChannel* channel = clip->channels + clip->channelCount++;
	*channel = ( toolChannel ){ .node = node, .path = path, .interpolation = interpolation };
	channel->times = toolAlloc( keyCount, sizeof *channel->times );
	channel->values = toolAlloc( keyCount, 4 * sizeof *channel->values );
	return channel;
}

static int toolPathWidth( toolPath path )
{
	return path == tool_pathRotation ? 4 : 3;
}

static void toolPutKey( toolChannel* channel, double time, const float* value )
{
	int width = toolPathWidth( channel->path );
	float* at = channel->values + (size_t)channel->keyCount * (size_t)width;
	memcpy( at, value, (size_t)width * sizeof *at );
	if ( width == 4 && channel->keyCount > 0 )
	{
		// The near one of the two quaternions that mean the same, for readers that do not look for it.
		double dot = 0.0;
		for ( int i = 0; i < 4; ++i )
		{
			dot += (double)at[i] * (double)at[i - 4];
		}
		for ( int i = 0; i < 4 && dot < 0.0; ++i )
		{
			at[i] = -at[i];
		}
	}
	channel->times[channel->keyCount] = (float)time;
	channel->keyCount += 1;
}

// A channel that never changes needs no more than its first and last key.
static void toolThinChannel( toolChannel* channel )
{
	size_t width = (size_t)toolPathWidth( channel->path );
	for ( int32_t i = 1; i < channel->keyCount; ++i )
	{
		if ( memcmp( channel->values, channel->values + (size_t)i * width, width * sizeof( float ) ) != 0 )
		{
			return;
		}
	}
	if ( channel->keyCount > 2 )
	{
		channel->times[1] = channel->times[channel->keyCount - 1];
		channel->keyCount = 2;
	}
}

// ----------------------------------------------------------------------------------------------- a key a frame

// Without the scale that the character's parentless nodes were given: as the file has it.
static soleTransform toolWithoutScale( const toolCharacter* character, soleTransform world )
{
	float scale = character->scale > 0.0f ? character->scale : 1.0f;
	world.translation = soleScale( 1.0f / scale, world.translation );
	world.scale = soleScale( 1.0f / scale, world.scale );
	return world;
}

static float toolDivideScale( float a, float b )
{
	return b != 0.0f ? a / b : a;
}

// Local transform of a keyed node in the file.
static soleTransform toolFileLocal( const toolClipMaker* maker, int32_t node, int32_t frame )
{
	const toolCharacter* character = maker->character;
	const toolBakeResult* result = maker->result;
	const soleTransform* pose = result->output + (size_t)frame * (size_t)result->jointCount;
	int32_t parent = character->parents[node];
	if ( node != maker->travel->node && parent != SOLE_NONE )
	{
		return pose[node];
	}
	soleTransform world = soleMulTransform( result->walk.roots[frame], toolPoseWorld( character, pose, node ) );
	soleTransform base = soleTransform_Identity();
	if ( parent != SOLE_NONE )
	{
		base = toolWithoutScale( character, toolPoseWorld( character, pose, parent ) );
	}
	soleTransform local = {
		soleInvTransformPoint( base, world.translation ),
		soleNormalizeQuat( soleMulQuat( soleConjugate( base.rotation ), world.rotation ) ),
		soleVec( toolDivideScale( world.scale.x, base.scale.x ), toolDivideScale( world.scale.y, base.scale.y ),
		    toolDivideScale( world.scale.z, base.scale.z ) ),
	};
	return local;
}

static void toolPartOf( soleTransform t, toolPath path, float value[4] )
{
	soleVec3 v = path == tool_pathScale ? t.scale : t.translation;
	float rotation[4] = { t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w };
	float vector[4] = { v.x, v.y, v.z, 0.0f };
	memcpy( value, path == tool_pathRotation ? rotation : vector, sizeof rotation );
}

static bool toolIsAnimated( const toolClipMaker* maker, int32_t node, toolPath path )
{
	for ( int32_t i = 0; i < maker->bound->clip->channelCount; ++i )
	{
		if ( maker->bound->nodes[i] == node && maker->bound->clip->channels[i].path == path )
		{
			return true;
		}
	}
	return false;
}

// Tracks of a node for what the clip animates and what the take has changed.
static void toolKeyNode( toolClipMaker* maker, int32_t node )
{
	soleTransform rest = maker->character->model->nodes[node].local;
	for ( int path = tool_pathTranslation; path <= tool_pathScale; ++path )
	{
		int32_t frames = maker->result->walk.frameCount;
		bool needed =
		    toolIsAnimated( maker, node, (toolPath)path ) || ( node == maker->travel->node && path != tool_pathScale );
		float restValue[4];
		toolPartOf( rest, (toolPath)path, restValue );
		toolChannel* channel = toolAddChannel( maker, node, (toolPath)path, tool_linear, (size_t)frames );
		for ( int32_t i = 0; i < frames; ++i )
		{
			float value[4];
			toolPartOf( toolFileLocal( maker, node, i ), (toolPath)path, value );
			toolPutKey( channel, (double)i / maker->result->walk.fps, value );
			for ( int j = 0; j < toolPathWidth( (toolPath)path ); ++j )
			{
				needed = needed || fabsf( value[j] - restValue[j] ) > 1e-6f * fmaxf( 1.0f, fabsf( restValue[j] ) );
			}
		}
		toolThinChannel( channel );
		if ( needed == false )
		{
			free( channel->times );
			free( channel->values );
			maker->clip->channelCount -= 1;
		}
	}
}

static void toolMarkChain( const toolCharacter* character, bool* marks, int32_t from, int32_t upTo )
{
	for ( int32_t i = from; i != SOLE_NONE; i = character->parents[i] )
	{
		marks[i] = true;
		if ( i == upTo )
		{
			return;
		}
	}
}

/// Whether a method has turned a joint: the one that carries the trunk may be left as it is.
static bool toolIsTurned( const toolBakeResult* result, int32_t joint )
{
	bool turned = false;
	for ( int32_t i = 0; i < result->walk.frameCount && joint != SOLE_NONE; ++i )
	{
		size_t at = (size_t)i * (size_t)result->jointCount + (size_t)joint;
		soleQuat in = result->input[at].rotation;
		soleQuat out = result->output[at].rotation;
		turned = turned || in.x != out.x || in.y != out.y || in.z != out.z || in.w != out.w;
	}
	return turned;
}

static bool* toolFindKeyedNodes(
    const toolCharacter* character, const toolTravel* travel, const toolBakeResult* result )
{
	bool* keyed = toolAlloc( (size_t)character->jointCount, sizeof *keyed );
	keyed[travel->node] = true;
	keyed[character->rigDef.pelvis] = true;
	int32_t spine = soleRig_GetSpine( character->rig );
	if ( toolIsTurned( result, spine ) )
	{
		keyed[spine] = true;
	}
	if ( travel->rootMotion )
	{
		toolMarkChain( character, keyed, travel->source, travel->node );
	}
	for ( int32_t i = 0; i < character->rigDef.legCount; ++i )
	{
		const soleLegDef* leg = character->rigDef.legs + i;
		toolMarkChain( character, keyed, leg->joints[leg->jointCount - 1], leg->joints[0] );
		if ( leg->detachedFoot != SOLE_NONE )
		{
			keyed[leg->detachedFoot] = true;
		}
		for ( int32_t j = 0; j < leg->toeCount; ++j )
		{
			keyed[leg->toes[j]] = true;
		}
	}
	return keyed;
}

// -------------------------------------------------------------------------------------------- the clip's own keys

// Adds a key behind the others. At the seam of two rounds it may fall on the last one. Then it is the same, or one of
// them makes room: the seam's own time belongs to the new round of a loop, and to the old one of what is no loop.
static void toolPutSeamKey( toolChannel* channel, bool loops, double time, const float* value )
{
	int32_t n = channel->keyCount;
	size_t width = (size_t)toolPathWidth( channel->path );
	if ( n > 0 && time - (double)channel->times[n - 1] < 1e-5 )
	{
		const float* last = channel->values + (size_t)( n - 1 ) * width;
		double apart = 0.0;
		double mirrored = 0.0;
		for ( size_t i = 0; i < width; ++i )
		{
			apart = fmax( apart, fabs( (double)value[i] - (double)last[i] ) );
			mirrored = fmax( mirrored, fabs( (double)value[i] + (double)last[i] ) );
		}
		bool same = apart < 1e-6 || ( width == 4 && mirrored < 1e-6 );
		if ( same || n == 1 )
		{
			return;
		}
		if ( channel->interpolation == tool_step )
		{
			channel->keyCount -= 1; // nothing is seen of a step that lasts no time
		}
		else if ( loops )
		{
			double before = (double)channel->times[n - 2];
			channel->times[n - 1] = (float)fmax( time - SEAM, 0.5 * ( before + time ) );
		}
		else
		{
			time = (double)channel->times[n - 1] + SEAM;
		}
	}
	if ( channel->keyCount > 0 && (float)time <= channel->times[channel->keyCount - 1] )
	{
		return;
	}
	toolPutKey( channel, time, value );
}

// One round of a channel's keys from a time on, held at both ends; stops behind the end of the take.
static void toolPutRound( const toolClipMaker* maker, const toolChannel* own, double start, toolChannel* channel )
{
	bool loops = maker->travel->loops;
	double rate = maker->result->walk.rate;
	double clipStart = (double)maker->bound->clip->start;
	double end = (double)( maker->result->walk.frameCount - 1 ) / maker->result->walk.fps;
	double round = (double)maker->bound->duration / rate;
	size_t width = (size_t)toolPathWidth( own->path );
	double first = ( (double)own->times[0] - clipStart ) / rate;
	if ( first > 1e-5 )
	{
		toolPutSeamKey( channel, loops, start, own->values );
	}
	double time = first;
	for ( int32_t i = 0; i < own->keyCount; ++i )
	{
		time = ( (double)own->times[i] - clipStart ) / rate;
		if ( start + time > end + 1e-6 )
		{
			break;
		}
		toolPutSeamKey( channel, loops, start + time, own->values + (size_t)i * width );
	}
	const float* last = own->values + (size_t)( own->keyCount - 1 ) * width;
	if ( round - time > 1e-5 && start + round < end && own->interpolation == tool_linear )
	{
		toolPutSeamKey( channel, loops, start + round, last );
	}
}

static void toolPutSampledKey( const toolClipMaker* maker, const toolChannel* own, double time, toolChannel* channel )
{
	toolRoundTime t = toolFindRound( maker->bound, maker->travel, time * maker->result->walk.rate );
	float value[4];
	toolSampleChannel( own, maker->bound->clip->start + (float)t.rest, value );
	if ( channel->keyCount == 0 || time - (double)channel->times[channel->keyCount - 1] > 1e-5 )
	{
		toolPutKey( channel, time, value );
	}
}

static bool toolIsConstant( const toolChannel* own )
{
	size_t width = (size_t)toolPathWidth( own->path );
	for ( int32_t i = 1; i < own->keyCount && own->interpolation != tool_cubic; ++i )
	{
		if ( memcmp( own->values, own->values + (size_t)i * width, width * sizeof( float ) ) != 0 )
		{
			return false;
		}
	}
	return own->interpolation != tool_cubic;
}

static void toolLoopChannel( toolClipMaker* maker, const toolChannel* own, int32_t node )
{
	int32_t frames = maker->result->walk.frameCount;
	double fps = maker->result->walk.fps;
	double end = (double)( frames - 1 ) / fps;
	double round = (double)maker->bound->duration / maker->result->walk.rate;
	if ( toolIsConstant( own ) || frames == 1 )
	{
		toolPutSampledKey( maker, own, 0.0, toolAddChannel( maker, node, own->path, tool_linear, 1 ) );
		return;
	}
	double rounds = ceil( end / round - 1e-9 );
	double keys = ( (double)own->keyCount + 2.0 ) * fmax( rounds, 1.0 ) + 2.0;
	// Keys far denser than the frames, of a clip of no length or a hostile one, are not worth keeping.
	if ( own->interpolation == tool_cubic || keys > 16.0 * (double)frames + 1000.0 )
	{
		toolChannel* channel = toolAddChannel( maker, node, own->path, tool_linear, (size_t)frames );
		for ( int32_t i = 0; i < frames; ++i )
		{
			toolPutSampledKey( maker, own, (double)i / fps, channel );
		}
		return;
	}
	toolChannel* channel = toolAddChannel( maker, node, own->path, own->interpolation, (size_t)keys );
	for ( double k = 0.0; k < rounds; k += 1.0 )
	{
		toolPutRound( maker, own, k * round, channel );
	}
	toolPutSampledKey( maker, own, end, channel );
}

// ----------------------------------------------------------------------------------------------------------- clip

static char* toolMakeExtras( const toolClipMaker* maker, const char* methodName, const char* clipsFile )
{
	const toolWalk* walk = &maker->result->walk;
	const toolCharacter* character = maker->character;
	struct json_object* inner = json_object_new_object();
	json_object_object_add( inner, "clip", json_object_new_string( maker->bound->clip->name ) );
	if ( clipsFile != NULL )
	{
		json_object_object_add( inner, "clips", json_object_new_string( clipsFile ) );
	}
	json_object_object_add( inner, "method", json_object_new_string( methodName ) );
	json_object_object_add( inner, "fps", json_object_new_double( walk->fps ) );
	json_object_object_add( inner, "frames", json_object_new_int( walk->frameCount ) );
	json_object_object_add( inner, "speed", json_object_new_double( walk->speed ) );
	json_object_object_add( inner, "rate", json_object_new_double( walk->rate ) );
	double scale = character->scale > 0.0f ? (double)character->scale : 1.0;
	json_object_object_add( inner, "scale", json_object_new_double( scale ) );
	json_object_object_add( inner, "travel", json_object_new_int( maker->travel->node ) );
	struct json_object* outer = json_object_new_object();
	json_object_object_add( outer, "sole", inner );
	char* text = toolCopyString( json_object_to_json_string_ext( outer, JSON_C_TO_STRING_PLAIN ) );
	json_object_put( outer );
	return text;
}

void toolMakeBakedClip( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const char* methodName, const char* clipsFile, const toolBakeResult* result, toolClip* clip )
{
	*clip = ( toolClip ){
		.name = toolFormat( "%s|%s", bound->clip->name, methodName ),
		.end = (float)( (double)( result->walk.frameCount - 1 ) / result->walk.fps ),
	};
	toolClipMaker maker = {
		.character = character,
		.bound = bound,
		.travel = travel,
		.result = result,
		.keyed = toolFindKeyedNodes( character, travel, result ),
		.clip = clip,
	};
	for ( int32_t i = 0; i < character->jointCount; ++i )
	{
		if ( maker.keyed[i] )
		{
			toolKeyNode( &maker, i );
		}
	}
	for ( int32_t i = 0; i < bound->clip->channelCount; ++i )
	{
		const toolChannel* own = bound->clip->channels + i;
		int32_t node = bound->nodes[i];
		if ( node != SOLE_NONE && maker.keyed[node] == false && own->keyCount > 0 )
		{
			toolLoopChannel( &maker, own, node );
		}
	}
	clip->extras = toolMakeExtras( &maker, methodName, clipsFile );
	free( maker.keyed );
}
