// SPDX-License-Identifier: MIT
// JSON as text: check it, find the bytes of a value, insert there. All other bytes stay as they are, which no library
// that parses and prints can promise. Reading what a text means is json-c's part.
#ifndef TOOL_JSON_SPLICE_H
#define TOOL_JSON_SPLICE_H

#include "tool.h"

/// Lists and objects may nest so deep.
#define TOOL_JSON_DEPTH 64

/// The bytes of one value, brackets or quotes included.
typedef struct toolJsonRange
{
	size_t begin;
	size_t end;
} toolJsonRange;

typedef struct toolJsonSummary
{
	toolJsonRange root;
	size_t memberCount;  // members of all objects: more than a parser keeps means that keys were given twice
	size_t badAt;        // where the first mistake is
	const char* problem; // what it is, or NULL
} toolJsonSummary;

/// Strict: one value, then nothing but white space or zero bytes (which some writers pad with). Strings with \u0000 are
/// refused, since C would read them differently. No recursion.
bool toolCheckJson( const char* text, size_t byteCount, toolJsonSummary* summary );

// The rest expects a text that toolCheckJson accepted, and ranges of it.

/// The value of a member, whose key is ASCII.
bool toolFindJsonMember( const char* text, toolJsonRange object, const char* key, toolJsonRange* value );
bool toolFindJsonItem( const char* text, toolJsonRange array, size_t index, toolJsonRange* value );
size_t toolCountJsonItems( const char* text, toolJsonRange array );

/// Text that grows. Always terminated once something was added.
typedef struct toolJsonText
{
	char* text;
	size_t count;
	size_t capacity;
} toolJsonText;

void toolAddJson( toolJsonText* out, const char* text );
void toolAddJsonBytes( toolJsonText* out, const char* text, size_t byteCount );
void toolAddJsonInteger( toolJsonText* out, size_t number );
/// The shortest of 9 digits that reads back as the same float.
void toolAddJsonFloat( toolJsonText* out, float number );
void toolAddJsonFloats( toolJsonText* out, const float* numbers, int32_t count );
/// With quotes; bytes that are no UTF-8 become U+FFFD.
void toolAddJsonString( toolJsonText* out, const char* text );

/// Changes to a text, made all at once by toolApplyJsonEdits. Zeroed memory is an empty list.
typedef struct toolJsonEdits
{
	struct toolJsonEdit* edits;
	size_t count;
} toolJsonEdits;

void toolReplaceJson( toolJsonEdits* edits, toolJsonRange range, const char* text );
/// At the end of a list or an object; text is one or more items or members, without the comma before them.
void toolAppendJson( toolJsonEdits* edits, const char* text, toolJsonRange container, const char* items );
/// The new text. Edits at the same place keep the order in which they were asked for. Frees the list.
char* toolApplyJsonEdits( toolJsonEdits* edits, const char* text, size_t byteCount, size_t* newCount );

/// Length of the UTF-8 sequence at text, or 0 where there is no valid one. Never looks behind a zero byte.
size_t toolUtf8Length( const char* text );

#endif
