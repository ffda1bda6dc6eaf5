// SPDX-License-Identifier: MIT
// What the names of joints say. A name is cut into lower-case words at separators, digits and changes of case; words
// for a side and words that rigs put before every name are taken out; what is left is looked up.
#include "detect_internal.h"

#include <string.h>

#define WORD_LIMIT 16
#define TEXT_LIMIT 96
#define SLOT_COUNT 1024

typedef struct soleWords
{
	char text[TEXT_LIMIT + WORD_LIMIT]; // words, each ended by 0
	int32_t starts[WORD_LIMIT];
	int32_t count;
} soleWords;

/// Words that stand first or last in many names of this skeleton: some rig's mark, not a part. Counted by hash.
typedef struct soleMarks
{
	int32_t first[SLOT_COUNT];
	int32_t last[SLOT_COUNT];
	int32_t named;
} soleMarks;

typedef struct solePartWord
{
	const char* word;
	soleNamePart part;
} solePartWord;

static const solePartWord solePartWords[] = {
	{ "hips", sole_partPelvis },
	{ "pelvis", sole_partPelvis },
	{ "hip", sole_partHip },
	{ "upleg", sole_partHip },
	{ "upperleg", sole_partHip },
	{ "legupper", sole_partHip },
	{ "legup", sole_partHip },
	{ "thigh", sole_partHip },
	{ "thighbone", sole_partHip },
	{ "femur", sole_partHip },
	{ "upperlimb", sole_partNone },
	{ "leg", sole_partLeg },
	{ "lowerleg", sole_partKnee },
	{ "lowleg", sole_partKnee },
	{ "leglower", sole_partKnee },
	{ "leglow", sole_partKnee },
	{ "shin", sole_partKnee },
	{ "shinbone", sole_partKnee },
	{ "calf", sole_partKnee },
	{ "knee", sole_partKnee },
	{ "tibia", sole_partKnee },
	{ "shank", sole_partKnee },
	{ "crus", sole_partKnee },
	{ "foot", sole_partAnkle },
	{ "ankle", sole_partAnkle },
	{ "footbase", sole_partAnkle },
	{ "toe", sole_partToe },
	{ "toes", sole_partToe },
	{ "toebase", sole_partToe },
	{ "ball", sole_partToe },
	{ "football", sole_partToe },
	{ "footthumb", sole_partToe },
	{ "foottoe", sole_partToe },
	{ "foottoes", sole_partToe },
	{ "bigtoe", sole_partToe },
	{ "toebig", sole_partToe },
	{ "hipjoint", sole_partOther },
	{ "buttock", sole_partOther },
	{ "heel", sole_partOther },
	{ "footheel", sole_partOther },
};

/// Names of MikuMikuDance models, whole: their words are not cut by separators.
typedef struct soleWholeName
{
	const char* name;
	soleNamePart part;
	soleSide side;
} soleWholeName;

static const soleWholeName soleWholeNames[] = {
	{ "\xe5\xb7\xa6\xe8\xb6\xb3", sole_partHip, sole_left },                          // left leg
	{ "\xe5\x8f\xb3\xe8\xb6\xb3", sole_partHip, sole_right },                         // right leg
	{ "\xe5\xb7\xa6\xe3\x81\xb2\xe3\x81\x96", sole_partKnee, sole_left },             // left knee
	{ "\xe5\x8f\xb3\xe3\x81\xb2\xe3\x81\x96", sole_partKnee, sole_right },            // right knee
	{ "\xe5\xb7\xa6\xe8\xb6\xb3\xe9\xa6\x96", sole_partAnkle, sole_left },            // left ankle
	{ "\xe5\x8f\xb3\xe8\xb6\xb3\xe9\xa6\x96", sole_partAnkle, sole_right },           // right ankle
	{ "\xe5\xb7\xa6\xe3\x81\xa4\xe3\x81\xbe\xe5\x85\x88", sole_partToe, sole_left },  // left toes
	{ "\xe5\x8f\xb3\xe3\x81\xa4\xe3\x81\xbe\xe5\x85\x88", sole_partToe, sole_right }, // right toes
	{ "\xe4\xb8\x8b\xe5\x8d\x8a\xe8\xba\xab", sole_partPelvis, sole_center },         // lower body
};

static const char* const soleLeftWords[] = { "l", "left", "lt", "lft" };
static const char* const soleRightWords[] = { "r", "right", "rt", "rgt" };
static const char* const soleEndWords[] = { "end", "nub", "tip", "leaf", "site", "endsite", "effector", "eff" };
static const char* const soleControlWords[] = { "ik", "fk", "mch", "org", "ctrl", "ctl", "control", "controller",
	"target", "pole", "tweak", "twist", "roll", "helper", "driver", "aim", "vis", "socket", "attach", "offset",
	"corrective", "jiggle" };
static const char* const soleGirdleWords[] = { "pelvis", "clavicle", "scapula", "anchor", "girdle" };
static const char* const soleMarkWords[] = { "j", "b", "bip", "biped", "valvebiped", "def", "deform", "mixamorig",
	"avatar", "armature", "rig", "jnt", "joint", "bone", "bn", "bind", "skin", "sk", "cc", "base", "character", "char",
	"skel", "skeleton", "stretch", "bend" };

#define IS_ONE_OF( word, list ) soleIsOneOf( word, list, sizeof( list ) / sizeof( ( list )[0] ) )

static bool soleIsOneOf( const char* word, const char* const* list, size_t count )
{
	for ( size_t i = 0; i < count; ++i )
	{
		if ( strcmp( word, list[i] ) == 0 )
		{
			return true;
		}
	}
	return false;
}

static uint32_t soleHashWord( const char* word )
{
	uint32_t hash = 2166136261u;
	for ( ; *word != 0; ++word )
	{
		hash = ( hash ^ (uint8_t)*word ) * 16777619u;
	}
	return hash;
}

// The locale has no say in names.
static bool soleIsUpper( char c )
{
	return c >= 'A' && c <= 'Z';
}

static bool soleIsLower( char c )
{
	return ( c >= 'a' && c <= 'z' ) || ( (uint8_t)c >= 0x80 );
}

static bool soleIsLetter( char c )
{
	return soleIsUpper( c ) || soleIsLower( c );
}

/// What stands behind the last namespace mark, if anything does.
static const char* soleSkipNamespace( const char* name )
{
	const char* start = name;
	for ( const char* c = name; *c != 0; ++c )
	{
		if ( ( *c == ':' || *c == '|' || *c == '/' ) && soleIsLetter( c[1] ) )
		{
			start = c + 1;
		}
	}
	return start;
}

static soleWords soleCutWords( const char* name )
{
	soleWords words = { 0 };
	int32_t used = 0;
	int32_t length = 0; // of the word at work
	const char* text = soleSkipNamespace( name );
	for ( int32_t i = 0; text[i] != 0 && i < TEXT_LIMIT; ++i )
	{
		char c = text[i];
		if ( soleIsLetter( c ) == false )
		{
			length = 0;
			continue;
		}
		bool cut = length > 0 && soleIsUpper( c ) && ( soleIsLower( text[i - 1] ) || soleIsLower( text[i + 1] ) );
		if ( length == 0 || cut )
		{
			if ( words.count == WORD_LIMIT )
			{
				break;
			}
			used += used > 0 ? 1 : 0;
			words.starts[words.count] = used;
			words.count += 1;
			length = 0;
		}
		words.text[used] = soleIsUpper( c ) ? (char)( c - 'A' + 'a' ) : c;
		used += 1;
		length += 1;
	}
	return words;
}

static const solePartWord* soleFindPart( const char* word )
{
	for ( size_t i = 0; i < sizeof( solePartWords ) / sizeof( solePartWords[0] ); ++i )
	{
		if ( strcmp( word, solePartWords[i].word ) == 0 )
		{
			return solePartWords + i;
		}
	}
	return NULL;
}

static soleSide soleFindSide( const char* word )
{
	if ( IS_ONE_OF( word, soleLeftWords ) )
	{
		return sole_left;
	}
	return IS_ONE_OF( word, soleRightWords ) ? sole_right : sole_center;
}

/// "lthigh", "leftupleg", "thighl", "footright": a side grown together with a part.
static const solePartWord* soleFindSidedPart( const char* word, soleSide* side )
{
	size_t length = strlen( word );
	static const char* const sides[] = { "left", "right", "l", "r" };
	for ( int32_t i = 0; i < 4; ++i )
	{
		size_t sideLength = strlen( sides[i] );
		if ( length <= sideLength || length >= TEXT_LIMIT )
		{
			continue;
		}
		const solePartWord* part = NULL;
		if ( strncmp( word, sides[i], sideLength ) == 0 )
		{
			part = soleFindPart( word + sideLength );
		}
		if ( part == NULL && strcmp( word + length - sideLength, sides[i] ) == 0 )
		{
			char rest[TEXT_LIMIT + WORD_LIMIT];
			memcpy( rest, word, length - sideLength );
			rest[length - sideLength] = 0;
			part = soleFindPart( rest );
		}
		if ( part != NULL )
		{
			*side = ( i & 1 ) == 0 ? sole_left : sole_right;
			return part;
		}
	}
	return NULL;
}

/// Some rig's mark: a known one, or a word that stands at this end of a third of all names.
static bool soleIsMark( const soleMarks* marks, const char* word, bool isFirst, bool isLast )
{
	if ( IS_ONE_OF( word, soleMarkWords ) )
	{
		return true;
	}
	if ( marks->named < 9 || soleFindPart( word ) != NULL || soleFindSide( word ) != sole_center )
	{
		return false;
	}
	uint32_t slot = soleHashWord( word ) % SLOT_COUNT;
	return ( isFirst && marks->first[slot] * 3 > marks->named ) || ( isLast && marks->last[slot] * 3 > marks->named );
}

static soleJointName soleParseName( const char* name, const soleMarks* marks )
{
	soleJointName result = { 0 };
	for ( size_t i = 0; i < sizeof soleWholeNames / sizeof soleWholeNames[0]; ++i )
	{
		if ( strcmp( name, soleWholeNames[i].name ) == 0 )
		{
			result.part = soleWholeNames[i].part;
			result.side = soleWholeNames[i].side;
			result.word = (uint32_t)i / 2;
			return result;
		}
	}
	soleWords words = soleCutWords( name );
	char whole[TEXT_LIMIT + WORD_LIMIT] = { 0 };
	char bare[TEXT_LIMIT + WORD_LIMIT] = { 0 };
	for ( int32_t i = 0; i < words.count; ++i )
	{
		const char* word = words.text + words.starts[i];
		soleSide side = soleFindSide( word );
		if ( side != sole_center )
		{
			result.side = result.side == sole_center ? side : result.side;
			continue;
		}
		if ( IS_ONE_OF( word, soleEndWords ) )
		{
			result.end = true;
			continue;
		}
		if ( IS_ONE_OF( word, soleControlWords ) )
		{
			result.control = true;
			continue;
		}
		result.girdle = result.girdle || IS_ONE_OF( word, soleGirdleWords );
		strcat( whole, word );
		if ( soleIsMark( marks, word, i == 0, i == words.count - 1 ) == false )
		{
			strcat( bare, word );
		}
	}
	const solePartWord* part = soleFindPart( whole );
	part = part != NULL ? part : soleFindPart( bare );
	if ( part == NULL && result.side == sole_center )
	{
		part = soleFindSidedPart( whole, &result.side );
		part = part != NULL ? part : soleFindSidedPart( bare, &result.side );
	}
	if ( part != NULL )
	{
		result.part = part->part;
		result.word = soleHashWord( part->word );
	}
	if ( result.side == sole_center && result.part != sole_partPelvis )
	{
		result.part = result.part == sole_partHip && strcmp( bare, "hip" ) == 0 ? sole_partPelvis : sole_partNone;
	}
	if ( result.control )
	{
		result.part = sole_partNone;
	}
	return result;
}

static void soleCountMarks( const soleDetect* detect, soleMarks* marks )
{
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		const char* name = detect->skeleton->names[i];
		if ( name == NULL || name[0] == 0 )
		{
			continue;
		}
		soleWords words = soleCutWords( name );
		if ( words.count > 1 )
		{
			marks->first[soleHashWord( words.text + words.starts[0] ) % SLOT_COUNT] += 1;
			marks->last[soleHashWord( words.text + words.starts[words.count - 1] ) % SLOT_COUNT] += 1;
		}
		marks->named += 1;
	}
}

void soleParseNames( soleDetect* detect )
{
	if ( detect->skeleton->names == NULL )
	{
		return;
	}
	soleMarks marks = { 0 };
	soleCountMarks( detect, &marks );
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		const char* name = detect->skeleton->names[i];
		if ( name != NULL && name[0] != 0 )
		{
			detect->names[i] = soleParseName( name, &marks );
		}
	}
}
