// SPDX-License-Identifier: MIT
// Makes takes, from memory and from baked files, and measures them. The world's up is +Y, as in all files.
#include "evaluate.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_TRANSFORMS 12000000 // of a take: 480 MB, and as much for the reference
#define MOST_FRAMES 500000
#define SETTLE_TIME 0.5   // s
#define FLAT_MARGIN 20.0f // leg lengths of flat ground around the way

// ----------------------------------------------------------------------------------------------------------- make

static soleVec3 toolUp( void )
{
	return soleVec( 0.0f, 1.0f, 0.0f );
}

int32_t toolGetSettleFrames( int32_t frameCount, double fps )
{
	return (int32_t)fmin( SETTLE_TIME * fps, 0.25 * (double)frameCount );
}

static bool toolAllocTake(
    const toolCharacter* character, int32_t frameCount, double fps, toolTake* take, toolError* error )
{
	*take = ( toolTake ){ .frameCount = frameCount, .frameRate = (float)fps };
	if ( frameCount < 1 || frameCount > MOST_FRAMES || frameCount > MOST_TRANSFORMS / character->jointCount )
	{
		toolFail( error, "%d frames of %d nodes cannot be held: take a shorter clip or a lower rate", frameCount,
		    character->jointCount );
		return false;
	}
	size_t frames = (size_t)frameCount;
	size_t joints = (size_t)character->jointCount;
	take->skip = toolGetSettleFrames( frameCount, fps );
	take->poses = toolAlloc( frames * joints, sizeof *take->poses );
	take->roots = toolAlloc( frames, sizeof *take->roots );
	take->referencePoses = toolAlloc( frames * joints, sizeof *take->referencePoses );
	take->referenceRoots = toolAlloc( frames, sizeof *take->referenceRoots );
	take->seams = toolAlloc( frames, sizeof *take->seams );
	take->labels = toolAlloc( frames * (size_t)soleRig_GetLegCount( character->rig ), 1 );
	return true;
}

void toolFreeTake( toolTake* take )
{
	free( take->poses );
	free( take->roots );
	free( take->referencePoses );
	free( take->referenceRoots );
	free( take->labels );
	free( take->seams );
	*take = ( toolTake ){ 0 };
}

/// The part of a root that goes along the floor: its heading and its place, the character's up made the world's, the
/// clip's floor at height 0.
static soleTransform toolFlattenRoot( const toolCharacter* character, soleTransform root, float clipFloor )
{
	soleQuat upright = soleFromTo( soleRig_GetUp( character->rig ), toolUp(), soleRig_GetForward( character->rig ) );
	soleQuat turn = soleMulQuat( root.rotation, soleConjugate( upright ) );
	soleQuat heading = soleNormalizeQuat( ( soleQuat ){ 0.0f, turn.y, 0.0f, turn.w } );
	soleTransform flat = {
		soleVec( root.translation.x, -clipFloor * root.scale.x, root.translation.z ),
		soleMulQuat( heading, upright ),
		root.scale,
	};
	return flat;
}

static soleMotion toolReferenceMotion( const toolCharacter* character, const toolTake* take )
{
	return ( soleMotion ){
		.rig = character->rig,
		.frameCount = take->frameCount,
		.frameRate = take->frameRate,
		.poses = take->referencePoses,
		.roots = take->referenceRoots,
		.up = toolUp(),
	};
}

/// From the reference, while that is still the clip on flat ground.
static bool toolLabelTake( const toolCharacter* character, float clipFloor, toolTake* take, toolError* error )
{
	soleMotion motion = toolReferenceMotion( character, take );
	motion.clipFloor = clipFloor;
	soleLabelDef def = soleDefaultLabelDef();
	if ( soleLabelContacts( &motion, &def, NULL, take->labels ) != sole_success )
	{
		return toolFail( error, "contacts cannot be labelled: not enough memory: take a shorter clip" );
	}
	return true;
}

bool toolMakeTake( const toolCharacter* character, const toolTakeDef* def, toolTake* take, toolError* error )
{
	if ( toolAllocTake( character, def->frameCount, def->frameRate, take, error ) == false )
	{
		return false;
	}
	size_t count = (size_t)def->frameCount * (size_t)character->jointCount;
	memcpy( take->poses, def->poses, count * sizeof *take->poses );
	memcpy( take->referencePoses, def->inputPoses, count * sizeof *take->poses );
	for ( int32_t i = 0; i < def->frameCount; ++i )
	{
		take->roots[i] = def->roots[i];
		take->referenceRoots[i] = toolFlattenRoot( character, def->inputRoots[i], def->clipFloor );
		take->seams[i] = def->seams != NULL && def->seams[i];
	}
	if ( toolLabelTake( character, def->clipFloor, take, error ) == false )
	{
		toolFreeTake( take );
		return false;
	}
	return true;
}

bool toolMakeClipTake( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, double fps,
    double rounds, toolTake* take, toolError* error )
{
	double frames = floor( rounds * (double)bound->duration * fps + 0.5 ) + 1.0;
	int32_t count = frames < (double)MOST_FRAMES ? (int32_t)frames : MOST_FRAMES + 1;
	if ( toolAllocTake( character, count, fps, take, error ) == false )
	{
		return false;
	}
	size_t joints = (size_t)character->jointCount;
	for ( int32_t i = 0; i < count; ++i )
	{
		double time = (double)i / fps;
		if ( travel->loops == false )
		{
			// One round only: its end is not the start of another.
			time = fmin( time, (double)bound->duration * ( 1.0 - 1e-7 ) );
		}
		soleTransform* pose = take->referencePoses + (size_t)i * joints;
		soleTransform root;
		toolSampleLooped( character, bound, travel, time, pose, &root );
		if ( travel->rootMotion == false )
		{
			root.translation = soleScale( (float)time, travel->strideVelocity );
		}
		soleQuat upright =
		    soleFromTo( soleRig_GetUp( character->rig ), toolUp(), soleRig_GetForward( character->rig ) );
		root.translation = soleRotate( upright, root.translation );
		root.rotation = soleMulQuat( upright, root.rotation );
		take->referenceRoots[i] = toolFlattenRoot( character, root, travel->clipFloor );
		take->seams[i] = toolCrossesSeam( bound, travel, (double)( i - 1 ) / fps, time );
	}
	memcpy( take->poses, take->referencePoses, (size_t)count * joints * sizeof *take->poses );
	memcpy( take->roots, take->referenceRoots, (size_t)count * sizeof *take->roots );
	if ( toolLabelTake( character, travel->clipFloor, take, error ) == false )
	{
		toolFreeTake( take );
		return false;
	}
	return true;
}

// --------------------------------------------------------------------------------------------------- baked clips

static void toolCopyText( struct json_object* from, const char* name, char* to, size_t size )
{
	struct json_object* value = NULL;
	if ( json_object_object_get_ex( from, name, &value ) && json_object_is_type( value, json_type_string ) )
	{
		snprintf( to, size, "%s", json_object_get_string( value ) );
	}
}

static double toolGetNumber( struct json_object* from, const char* name, double otherwise )
{
	struct json_object* value = NULL;
	bool there = json_object_object_get_ex( from, name, &value ) &&
	    ( json_object_is_type( value, json_type_double ) || json_object_is_type( value, json_type_int ) );
	return there ? json_object_get_double( value ) : otherwise;
}

bool toolReadBakeInfo( const toolClip* clip, toolBakeInfo* info )
{
	*info = ( toolBakeInfo ){ .travel = SOLE_NONE };
	struct json_object* extras = clip->extras != NULL ? json_tokener_parse( clip->extras ) : NULL;
	struct json_object* sole = NULL;
	bool good = extras != NULL && json_object_is_type( extras, json_type_object ) &&
	    json_object_object_get_ex( extras, "sole", &sole ) && json_object_is_type( sole, json_type_object );
	if ( good )
	{
		toolCopyText( sole, "clip", info->clip, sizeof info->clip );
		toolCopyText( sole, "method", info->method, sizeof info->method );
		toolCopyText( sole, "clips", info->clips, sizeof info->clips );
		info->fps = toolGetNumber( sole, "fps", 0.0 );
		info->rate = toolGetNumber( sole, "rate", 1.0 );
		info->scale = toolGetNumber( sole, "scale", 1.0 );
		double frames = toolGetNumber( sole, "frames", 0.0 );
		double travel = toolGetNumber( sole, "travel", -1.0 );
		// Who wrote this is not known: what is out of bounds makes it no bake of ours.
		good = info->clip[0] != 0 && info->fps >= 1.0 && info->fps <= 10000.0 && info->rate > 0.0 &&
		    info->rate <= 1000.0 && info->scale > 1e-9 && info->scale < 1e9 && frames >= 1.0 &&
		    frames <= (double)MOST_FRAMES && travel >= 0.0 && travel < 1e9;
		info->frameCount = good ? (int32_t)frames : 0;
		info->travel = good ? (int32_t)travel : SOLE_NONE;
	}
	json_object_put( extras );
	return good;
}

/// Poses of a baked clip as they are.
static bool toolSampleBaked( const toolCharacter* character, int32_t clip, int32_t frameCount, double fps,
    soleTransform* poses, toolError* error )
{
	toolBoundClip bound;
	if ( toolBindClip( character, character->model, clip, &bound, error ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < frameCount; ++i )
	{
		float time = (float)( (double)i / fps );
		toolSampleClip( character, &bound, time, poses + (size_t)i * (size_t)character->jointCount );
	}
	toolFreeBoundClip( &bound );
	return true;
}

/// What a node's place in one pose has to be moved by to be that in another; no scale.
static soleTransform toolFindMove( soleTransform from, soleTransform to )
{
	soleTransform move = soleTransform_Identity();
	move.rotation = soleNormalizeQuat( soleMulQuat( to.rotation, soleConjugate( from.rotation ) ) );
	move.translation = soleSub( to.translation, soleRotate( move.rotation, from.translation ) );
	return move;
}

bool toolRebuildTake( const toolCharacter* character, int32_t bakedClip, const toolBakeInfo* info,
    const toolBoundClip* base, toolTake* take, toolError* error )
{
	if ( info->travel >= character->jointCount )
	{
		return toolFail( error, "clip '%s': its travel node %d is not in the file: bake it again",
		    character->model->clips[bakedClip].name, info->travel );
	}
	if ( toolAllocTake( character, info->frameCount, info->fps, take, error ) == false )
	{
		return false;
	}
	if ( toolSampleBaked( character, bakedClip, info->frameCount, info->fps, take->poses, error ) == false )
	{
		toolFreeTake( take );
		return false;
	}
	toolTravel travel = toolFindTravel( character, base );
	size_t joints = (size_t)character->jointCount;
	for ( int32_t i = 0; i < info->frameCount; ++i )
	{
		soleTransform own; // what it does to the root is in the baked travel
		double time = (double)i / info->fps * info->rate;
		soleTransform* input = take->referencePoses + (size_t)i * joints;
		soleTransform* pose = take->poses + (size_t)i * joints;
		toolSampleLooped( character, base, &travel, time, input, &own );
		soleTransform from = toolPoseWorld( character, input, info->travel );
		soleTransform to = toolPoseWorld( character, pose, info->travel );
		// The travel goes back from the pose to the root, as far as it can be told from what a method did to its node.
		take->roots[i] = toolFindMove( from, to );
		toolMovePose( character, pose, info->travel, toolFindMove( to, from ) );
		take->referenceRoots[i] = toolFlattenRoot( character, take->roots[i], travel.clipFloor );
		take->seams[i] = toolCrossesSeam( base, &travel, time - info->rate / info->fps, time );
	}
	if ( toolLabelTake( character, travel.clipFloor, take, error ) == false )
	{
		toolFreeTake( take );
		return false;
	}
	return true;
}

bool toolReplaceReference( const toolCharacter* character, int32_t clip, toolTake* take, toolError* error )
{
	const toolClip* reference = character->model->clips + clip;
	toolBakeInfo info;
	bool alike = toolReadBakeInfo( reference, &info ) && info.frameCount == take->frameCount &&
	    info.travel < character->jointCount && fabs( info.fps - (double)take->frameRate ) < 1e-3;
	if ( alike == false )
	{
		return toolFail( error, "clip '%s' is no bake of %d frames at %g fps: bake both in one run", reference->name,
		    take->frameCount, (double)take->frameRate );
	}
	if ( toolSampleBaked( character, clip, take->frameCount, info.fps, take->referencePoses, error ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < take->frameCount; ++i )
	{
		soleTransform* pose = take->referencePoses + (size_t)i * (size_t)character->jointCount;
		toolMovePose( character, pose, info.travel, toolFindMove( take->roots[i], soleTransform_Identity() ) );
		take->referenceRoots[i] = take->roots[i];
	}
	take->referenceOnGround = true;
	return true;
}

// -------------------------------------------------------------------------------------------------------- measure

/// Flat ground at height 0 under all of the reference's way.
static soleTerrain* toolMakeFlat( const toolCharacter* character, const toolTake* take )
{
	float margin = FLAT_MARGIN * soleRig_GetLegLength( character->rig, 0 ) * take->referenceRoots[0].scale.x;
	soleVec3 low = take->referenceRoots[0].translation;
	soleVec3 high = low;
	for ( int32_t i = 1; i < take->frameCount; ++i )
	{
		soleVec3 p = take->referenceRoots[i].translation;
		low.x = soleMinF( low.x, p.x );
		low.z = soleMinF( low.z, p.z );
		high.x = soleMaxF( high.x, p.x );
		high.z = soleMaxF( high.z, p.z );
	}
	float positions[12] = { low.x - margin, 0.0f, low.z - margin, low.x - margin, 0.0f, high.z + margin,
		high.x + margin, 0.0f, high.z + margin, high.x + margin, 0.0f, low.z - margin };
	uint32_t indices[6] = { 0, 1, 2, 0, 2, 3 };
	soleTerrain* terrain = NULL;
	soleCreateTerrain( positions, 4, indices, 2, toolUp(), NULL, &terrain, NULL );
	return terrain;
}

/// What it takes to measure a take and its reference.
typedef struct toolMeasuring
{
	soleMotion motion;
	soleMotion reference;
	soleTerrain* flat; // NULL: the reference is over the same terrain
	soleMeasureDef def;
	soleMeasureDef referenceDef;
} toolMeasuring;

static void toolStartMeasuring(
    const toolCharacter* character, const toolTake* take, const soleTerrain* terrain, toolMeasuring* measuring )
{
	measuring->reference = toolReferenceMotion( character, take );
	measuring->motion = measuring->reference;
	measuring->motion.poses = take->poses;
	measuring->motion.roots = take->roots;
	measuring->flat = take->referenceOnGround ? NULL : toolMakeFlat( character, take );
	soleMeasureDef def = soleDefaultMeasureDef();
	def.labels = take->labels;
	def.points = character->points;
	def.pointCount = character->pointCount;
	def.skip = take->skip;
	def.seams = take->seams;
	def.motion = &measuring->reference;
	def.terrain = take->referenceOnGround ? terrain : measuring->flat;
	measuring->referenceDef = def;
	def.motion = &measuring->motion;
	def.reference = &measuring->reference;
	def.terrain = terrain;
	measuring->def = def;
}

static bool toolEndMeasuring(
    const toolMeasuring* measuring, soleResult result, const soleMessage* message, toolError* error )
{
	soleDestroyTerrain( measuring->flat );
	return result == sole_success || toolFail( error, "the motion cannot be measured: %s", message->text );
}

bool toolMeasureTake( const toolCharacter* character, const toolTake* take, const soleTerrain* terrain,
    soleFigures* figures, soleFigures* referenceFigures, toolError* error )
{
	toolMeasuring measuring;
	soleMessage message = { { 0 } };
	toolStartMeasuring( character, take, terrain, &measuring );
	soleResult result = soleMeasureMotion( &measuring.def, NULL, figures, &message );
	if ( result == sole_success && referenceFigures != NULL )
	{
		result = soleMeasureMotion( &measuring.referenceDef, NULL, referenceFigures, &message );
	}
	return toolEndMeasuring( &measuring, result, &message, error );
}

bool toolMeasureTakePublished( const toolCharacter* character, const toolTake* take, const soleTerrain* terrain,
    solePublishedFigures* figures, solePublishedFigures* referenceFigures, toolError* error )
{
	toolMeasuring measuring;
	soleMessage message = { { 0 } };
	toolStartMeasuring( character, take, terrain, &measuring );
	soleResult result = soleMeasurePublished( &measuring.def, NULL, figures, &message );
	if ( result == sole_success )
	{
		result = soleMeasurePublished( &measuring.referenceDef, NULL, referenceFigures, &message );
	}
	return toolEndMeasuring( &measuring, result, &message, error );
}

bool toolMakeBakeTake( const toolCharacter* character, const toolBakeResult* result, toolTake* take, toolError* error )
{
	toolTakeDef def = {
		.frameCount = result->walk.frameCount,
		.frameRate = result->walk.fps,
		.clipFloor = result->clipFloor,
		.poses = result->output,
		.roots = result->walk.roots,
		.inputPoses = result->input,
		.inputRoots = result->walk.roots,
		.seams = result->walk.seams,
	};
	return toolMakeTake( character, &def, take, error );
}

double toolFindShortfall( const toolBakeResult* result, const toolTake* take )
{
	double most = (double)NAN;
	for ( int32_t i = take->skip * result->legCount; i < take->frameCount * result->legCount; ++i )
	{
		if ( take->labels[i] != sole_labelNone )
		{
			most = fmax( most, (double)result->shortfalls[i] ); // of a number and none the number
		}
	}
	return most;
}

bool toolMeasureBake( const toolCharacter* character, const toolBakeResult* result, const soleTerrain* terrain,
    soleFigures* figures, soleFigures* referenceFigures, toolError* error )
{
	toolTake take;
	if ( toolMakeBakeTake( character, result, &take, error ) == false )
	{
		return false;
	}
	bool good = toolMeasureTake( character, &take, terrain, figures, referenceFigures, error );
	toolFreeTake( &take );
	return good;
}
