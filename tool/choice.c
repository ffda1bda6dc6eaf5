// SPDX-License-Identifier: MIT
// What is taken where the user does not say: which clip, and where to start. World of the ground, metres, Y up.
#include "source.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#define PI 3.14159265358979
#define SAMPLE_STEP 0.25 // m between the places that are looked at along a way
#define MOST_SAMPLES 400 // of one way
#define RINGS 12         // of starts around the middle
#define RING_STARTS 16

// ----------------------------------------------------------------------------------------------------------- clip

// Is a word part of a name, whatever the case?
static bool toolNameHas( const char* name, const char* word )
{
	size_t length = strlen( word );
	for ( ; *name != 0; ++name )
	{
		size_t i = 0;
		while ( i < length && tolower( (unsigned char)name[i] ) == word[i] )
		{
			++i;
		}
		if ( i == length )
		{
			return true;
		}
	}
	return false;
}

static bool toolNameHasAny( const char* name, const char* const* words )
{
	for ( ; *words != NULL; ++words )
	{
		if ( toolNameHas( name, *words ) )
		{
			return true;
		}
	}
	return false;
}

static const char* const toolQualifiers[] = { "back", "crouch", "formal", "strafe", "left", "right", "start", "stop",
	"turn", "jump", "limp", "zombie", "carry", "injur", "drunk", "hold", "|", NULL };
static const char* const toolGaits[] = { "jog", "run", "sprint", "trot", "gallop", "canter", "sneak", "crawl", NULL };

// Of those that pass, the one with the shortest name, which has the fewest qualifiers.
static int32_t toolShortestName( const toolModel* model, const char* word, bool plain )
{
	int32_t best = SOLE_NONE;
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		// What stands before the last bar is the name of the armature.
		const char* name = model->clips[i].name;
		const char* bar = strrchr( name, '|' );
		const char* action = bar != NULL && strcmp( bar, "|sole" ) != 0 && strcmp( bar, "|none" ) != 0 ? bar + 1 : name;
		bool passes =
		    toolNameHas( action, word ) && ( plain == false || toolNameHasAny( action, toolQualifiers ) == false );
		if ( passes && ( best == SOLE_NONE || strlen( name ) < strlen( model->clips[best].name ) ) )
		{
			best = i;
		}
	}
	return best;
}

int32_t toolChooseClip( const toolModel* model )
{
	int32_t clip = toolShortestName( model, "walk", true );
	clip = clip != SOLE_NONE ? clip : toolShortestName( model, "walk", false );
	for ( const char* const* gait = toolGaits; *gait != NULL && clip == SOLE_NONE; ++gait )
	{
		clip = toolShortestName( model, *gait, true );
	}
	return clip == SOLE_NONE && model->clipCount > 0 ? 0 : clip;
}

bool toolBindNamedClip( const toolCharacter* character, const toolModel* clipModel, const char* file, const char* name,
    toolBoundClip* bound, toolError* error )
{
	int32_t index = name != NULL ? toolFindClip( clipModel, name ) : toolChooseClip( clipModel );
	if ( index == SOLE_NONE && name != NULL )
	{
		return toolFail( error, "%s: has no clip '%s': 'sole inspect' lists its clips", file, name );
	}
	if ( index == SOLE_NONE && clipModel != character->model )
	{
		return toolFail( error, "%s: has no clips: give a file that has them with --clips", file );
	}
	if ( index == SOLE_NONE )
	{
		toolBindRest( bound );
		return true;
	}
	return toolBindClip( character, clipModel, index, bound, error ) || toolFailIn( error, file );
}

// ---------------------------------------------------------------------------------------------------------- start

// How well a way can be walked: 0 not at all, 1 with steps that are too high, 2 well.
static int toolRateWay( const soleGround* ground, toolPlace start, double heading, double distance, double step )
{
	int count = (int)fmin( ceil( distance / SAMPLE_STEP ), (double)MOST_SAMPLES );
	int rating = 2;
	double last = 0.0;
	for ( int i = 0; i <= count; ++i )
	{
		double along = count > 0 ? distance * (double)i / (double)count : 0.0;
		toolPlace place = { start.x + along * sin( heading ), (double)NAN, start.z + along * cos( heading ) };
		if ( toolFindGround( ground, "", &place, NULL ) == false )
		{
			return 0;
		}
		rating = i > 0 && fabs( place.y - last ) > step ? 1 : rating;
		last = place.y;
	}
	return rating;
}

bool toolChooseStart( const soleGround* ground, const char* groundName, double heading, double distance, double step,
    toolPlace* start, toolError* error )
{
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	bool bounded = lower.x <= upper.x;
	double angle = heading * PI / 180.0;
	double width = bounded ? (double)( upper.x - lower.x ) : 0.0;
	double depth = bounded ? (double)( upper.z - lower.z ) : 0.0;
	toolPlace middle = { bounded ? 0.5 * (double)( lower.x + upper.x ) : 0.0, (double)NAN,
		bounded ? 0.5 * (double)( lower.z + upper.z ) : 0.0 };
	int best = 0;
	for ( int i = 0; i <= RINGS * RING_STARTS && best < 2; ++i )
	{
		double reach = i == 0 ? 0.0 : 0.5 * (double)( ( i - 1 ) / RING_STARTS + 1 ) / (double)RINGS;
		double around = 2.0 * PI * (double)( i % RING_STARTS ) / (double)RING_STARTS;
		// The way's middle is looked for, for it is the ground's middle that is wanted.
		toolPlace from = { middle.x + reach * width * sin( around ) - 0.5 * distance * sin( angle ), (double)NAN,
			middle.z + reach * depth * cos( around ) - 0.5 * distance * cos( angle ) };
		int rating = toolRateWay( ground, from, angle, distance, step );
		if ( rating > best )
		{
			best = rating;
			*start = from;
		}
	}
	if ( best == 0 )
	{
		return toolFail( error,
		    "%s: has no ground for %.3g m straight on: give --path, or --start, --heading and --distance", groundName,
		    distance );
	}
	return true;
}
