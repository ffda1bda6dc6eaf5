// SPDX-License-Identifier: MIT
// What 'sole inspect' found, as text and as JSON. SI units, character space.
#include "inspect.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char* const toolSideNames[] = { "center", "left", "right" };
static const char* const toolSeverityNames[] = { "info", "warning", "error" };

static const char* toolJointName( const toolCharacter* character, int32_t joint )
{
	return joint != SOLE_NONE ? character->names[joint] : "";
}

/// The joint that is the foot: the ankle, or the joint of a detached foot.
static int32_t toolFootOf( const soleLegDef* leg )
{
	if ( leg->detachedFoot != SOLE_NONE )
	{
		return leg->detachedFoot;
	}
	return leg->hasVirtualAnkle ? SOLE_NONE : leg->joints[leg->jointCount - 1];
}

// ------------------------------------------------------------------------------------------------------------ text

/// "+Z" where it is an axis, else its numbers.
static void toolPrintDirection( const char* what, soleVec3 v )
{
	const float values[3] = { v.x, v.y, v.z };
	for ( int32_t i = 0; i < 3; ++i )
	{
		if ( values[i] > 0.9999f || values[i] < -0.9999f )
		{
			printf( "%s %c%c", what, values[i] > 0.0f ? '+' : '-', "XYZ"[i] );
			return;
		}
	}
	printf( "%s (%.3f, %.3f, %.3f)", what, (double)v.x, (double)v.y, (double)v.z );
}

static void toolPrintFindings( const toolCharacter* character, int32_t leg )
{
	for ( int32_t i = 0; i < character->report.findingCount; ++i )
	{
		const soleFinding* finding = character->report.findings + i;
		if ( finding->leg == leg && finding->severity == sole_info )
		{
			printf( "  %s%s%s\n", leg == SOLE_NONE ? finding->where : "", leg == SOLE_NONE ? ": " : "", finding->what );
		}
	}
}

static void toolPrintLeg( const toolCharacter* character, int32_t index )
{
	const soleLegDef* leg = character->rigDef.legs + index;
	printf( "\nleg %s\n  joints ", leg->name );
	for ( int32_t i = 0; i < leg->jointCount; ++i )
	{
		printf( "%s%s", i > 0 ? " > " : "", toolJointName( character, leg->joints[i] ) );
	}
	printf( "%s", leg->hasVirtualAnkle ? " > (no ankle joint)" : "" );
	for ( int32_t i = 0; i < leg->toeCount; ++i )
	{
		printf( "%s%s", i > 0 ? " > " : "; toe ", toolJointName( character, leg->toes[i] ) );
	}
	if ( leg->detachedFoot != SOLE_NONE )
	{
		printf( "; detached foot %s", toolJointName( character, leg->detachedFoot ) );
	}
	const soleSolePoints* sole = &leg->sole;
	printf( "\n  length %.3f m; sole %.3f m long, %.3f m wide, at height %.3f m; ",
	    (double)soleRig_GetLegLength( character->rig, index ), (double)soleDistance( sole->heel, sole->toe ),
	    (double)soleDistance( sole->inner, sole->outer ), (double)soleDot( sole->ball, character->rigDef.up ) );
	toolPrintDirection( "hinge", leg->hinge );
	printf( "\n" );
	toolPrintFindings( character, index );
}

static void toolPrintClip( const toolCharacter* character, const toolClipFacts* facts )
{
	if ( facts->refused )
	{
		printf( "  %-28s %s\n", facts->clip->name, facts->error.text );
		return;
	}
	printf( "  %-28s %6.2f s  %3.0f fps  %-11s %5.2f m/s\n", facts->clip->name, (double)facts->duration,
	    (double)facts->travel.frameRate, facts->travel.rootMotion ? "root motion" : "in place",
	    (double)facts->strideSpeed );
	for ( int32_t leg = 0; leg < character->rigDef.legCount; ++leg )
	{
		const toolLegContacts* contacts = facts->legs + leg;
		printf( "    %-12s", character->rigDef.legs[leg].name );
		for ( int32_t i = 0; i < contacts->count; ++i )
		{
			printf( " %.2f-%.2f", (double)contacts->intervals[i].start, (double)contacts->intervals[i].end );
		}
		printf( "%s\n", contacts->count == 0 ? " no contact" : "" );
	}
}

static int32_t toolPrintProblems( const toolCharacter* character )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < character->report.findingCount; ++i )
	{
		const soleFinding* finding = character->report.findings + i;
		if ( finding->severity == sole_info )
		{
			continue;
		}
		printf( "%s  %s: %s: %s: %s\n", count == 0 ? "\nproblems\n" : "", toolSeverityNames[finding->severity],
		    finding->where, finding->what, finding->mend );
		count += 1;
	}
	return count;
}

void toolPrintInspection( const char* path, const toolCharacter* character, const toolClipFacts* facts )
{
	const soleRigDef* def = &character->rigDef;
	printf( "%s: %d joints, %d legs, ", path, (int)character->jointCount, (int)def->legCount );
	toolPrintDirection( "up", def->up );
	toolPrintDirection( ", facing", def->forward );
	printf( ", scale %g\n  pelvis %s; travels in %s\n", (double)character->scale,
	    toolJointName( character, def->pelvis ), toolJointName( character, character->travel ) );
	toolPrintFindings( character, SOLE_NONE );
	for ( int32_t i = 0; i < def->legCount; ++i )
	{
		toolPrintLeg( character, i );
	}
	int32_t clips = character->model->clipCount;
	printf( "\nclips (contacts in seconds)\n%s", clips == 0 ? "  none\n" : "" );
	for ( int32_t i = 0; i < clips; ++i )
	{
		toolPrintClip( character, facts + i );
	}
	if ( toolPrintProblems( character ) == 0 )
	{
		printf( "\nno problems\n" );
	}
}

// ------------------------------------------------------------------------------------------------------------ JSON

/// Six digits are more than a float of such sizes has.
static struct json_object* toolJsonNumber( double value )
{
	if ( isfinite( value ) == 0 )
	{
		return NULL; // null: JSON has no other word for it
	}
	char text[32];
	snprintf( text, sizeof text, "%.6g", value == 0.0 ? 0.0 : value );
	return json_object_new_double_s( strtod( text, NULL ), text );
}

static struct json_object* toolJsonVector( soleVec3 v )
{
	struct json_object* array = json_object_new_array();
	json_object_array_add( array, toolJsonNumber( (double)v.x ) );
	json_object_array_add( array, toolJsonNumber( (double)v.y ) );
	json_object_array_add( array, toolJsonNumber( (double)v.z ) );
	return array;
}

static struct json_object* toolJsonJoint( const toolCharacter* character, int32_t joint )
{
	return joint == SOLE_NONE ? NULL : json_object_new_string( toolJointName( character, joint ) );
}

static struct json_object* toolJsonLeg( const toolCharacter* character, int32_t index )
{
	const soleLegDef* leg = character->rigDef.legs + index;
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "name", json_object_new_string( leg->name ) );
	json_object_object_add( object, "side", json_object_new_string( toolSideNames[leg->side] ) );
	struct json_object* joints = json_object_new_array();
	for ( int32_t i = 0; i < leg->jointCount; ++i )
	{
		json_object_array_add( joints, toolJsonJoint( character, leg->joints[i] ) );
	}
	json_object_object_add( object, "joints", joints );
	json_object_object_add( object, "foot", toolJsonJoint( character, toolFootOf( leg ) ) );
	json_object_object_add( object, "toe", toolJsonJoint( character, leg->toeCount > 0 ? leg->toes[0] : SOLE_NONE ) );
	json_object_object_add( object, "detached", json_object_new_boolean( leg->detachedFoot != SOLE_NONE ) );
	json_object_object_add( object, "length", toolJsonNumber( (double)soleRig_GetLegLength( character->rig, index ) ) );
	json_object_object_add( object, "hinge", toolJsonVector( leg->hinge ) );
	struct json_object* sole = json_object_new_object();
	json_object_object_add( sole, "heel", toolJsonVector( leg->sole.heel ) );
	json_object_object_add( sole, "ball", toolJsonVector( leg->sole.ball ) );
	json_object_object_add( sole, "toe", toolJsonVector( leg->sole.toe ) );
	json_object_object_add( sole, "inner", toolJsonVector( leg->sole.inner ) );
	json_object_object_add( sole, "outer", toolJsonVector( leg->sole.outer ) );
	json_object_object_add( object, "sole", sole );
	struct json_object* why = json_object_new_array();
	for ( int32_t i = 0; i < character->report.findingCount; ++i )
	{
		const soleFinding* finding = character->report.findings + i;
		if ( finding->leg == index && finding->severity == sole_info )
		{
			json_object_array_add( why, json_object_new_string( finding->what ) );
		}
	}
	json_object_object_add( object, "why", why );
	return object;
}

static struct json_object* toolJsonClip( const toolCharacter* character, const toolClipFacts* facts )
{
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "name", json_object_new_string( facts->clip->name ) );
	json_object_object_add( object, "duration", toolJsonNumber( (double)facts->duration ) );
	json_object_object_add( object, "fps", toolJsonNumber( (double)facts->travel.frameRate ) );
	json_object_object_add(
	    object, "motion", json_object_new_string( facts->travel.rootMotion ? "root" : "in-place" ) );
	json_object_object_add( object, "strideSpeed", toolJsonNumber( (double)facts->strideSpeed ) );
	struct json_object* contacts = json_object_new_array();
	for ( int32_t leg = 0; leg < character->rigDef.legCount; ++leg )
	{
		struct json_object* entry = json_object_new_object();
		struct json_object* intervals = json_object_new_array();
		for ( int32_t i = 0; i < facts->legs[leg].count; ++i )
		{
			struct json_object* interval = json_object_new_array();
			json_object_array_add( interval, toolJsonNumber( (double)facts->legs[leg].intervals[i].start ) );
			json_object_array_add( interval, toolJsonNumber( (double)facts->legs[leg].intervals[i].end ) );
			json_object_array_add( intervals, interval );
		}
		json_object_object_add( entry, "leg", json_object_new_string( character->rigDef.legs[leg].name ) );
		json_object_object_add( entry, "intervals", intervals );
		json_object_array_add( contacts, entry );
	}
	json_object_object_add( object, "contacts", contacts );
	return object;
}

static void toolJsonProblem(
    struct json_object* problems, const char* severity, const char* where, const char* what, const char* mend )
{
	struct json_object* problem = json_object_new_object();
	json_object_object_add( problem, "severity", json_object_new_string( severity ) );
	json_object_object_add( problem, "where", json_object_new_string( where ) );
	json_object_object_add( problem, "what", json_object_new_string( what ) );
	json_object_object_add( problem, "mend", json_object_new_string( mend ) );
	json_object_array_add( problems, problem );
}

static struct json_object* toolJsonProblems( const toolCharacter* character, const toolClipFacts* facts )
{
	struct json_object* problems = json_object_new_array();
	for ( int32_t i = 0; i < character->report.findingCount; ++i )
	{
		const soleFinding* finding = character->report.findings + i;
		if ( finding->severity != sole_info )
		{
			toolJsonProblem(
			    problems, toolSeverityNames[finding->severity], finding->where, finding->what, finding->mend );
		}
	}
	for ( int32_t i = 0; i < character->model->clipCount; ++i )
	{
		if ( facts[i].refused )
		{
			char* where = toolFormat( "clip %s", facts[i].clip->name );
			toolJsonProblem( problems, "warning", where, facts[i].error.text, "leave this clip out" );
			free( where );
		}
	}
	return problems;
}

void toolPrintInspectionJson( const char* path, const toolCharacter* character, const toolClipFacts* facts )
{
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "file", json_object_new_string( path ) );
	json_object_object_add( object, "scale", toolJsonNumber( (double)character->scale ) );
	json_object_object_add( object, "up", toolJsonVector( character->rigDef.up ) );
	json_object_object_add( object, "facing", toolJsonVector( character->rigDef.forward ) );
	struct json_object* legs = json_object_new_array();
	for ( int32_t i = 0; i < character->rigDef.legCount; ++i )
	{
		json_object_array_add( legs, toolJsonLeg( character, i ) );
	}
	json_object_object_add( object, "legs", legs );
	json_object_object_add( object, "pelvis", toolJsonJoint( character, character->rigDef.pelvis ) );
	struct json_object* clips = json_object_new_array();
	for ( int32_t i = 0; i < character->model->clipCount; ++i )
	{
		if ( facts[i].refused == false )
		{
			json_object_array_add( clips, toolJsonClip( character, facts + i ) );
		}
	}
	json_object_object_add( object, "clips", clips );
	json_object_object_add( object, "problems", toolJsonProblems( character, facts ) );
	puts( json_object_to_json_string_ext(
	    object, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED | JSON_C_TO_STRING_NOSLASHESCAPE ) );
	json_object_put( object );
}
