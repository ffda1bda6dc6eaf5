// SPDX-License-Identifier: MIT
// Takes: sampled motions of a character over ground, with what they are judged against: the same clip moved along flat
// ground without foot placement, and contact labels made from that.
#ifndef TOOL_EVALUATE_H
#define TOOL_EVALUATE_H

#include "bake.h"

/// Frames at the start of a take that are not measured: half a second in which methods may settle, but never more than
/// a quarter of the take.
int32_t toolGetSettleFrames( int32_t frameCount, double fps );

typedef struct toolTake
{
	int32_t frameCount;
	float frameRate;
	/// Frames at the start that are not measured.
	int32_t skip;
	soleTransform* poses; // frameCount * jointCount, parent-local
	soleTransform* roots; // frameCount, character space to world
	soleTransform* referencePoses;
	/// Along the floor at height 0, such that the clip's own floor lies on it.
	soleTransform* referenceRoots;
	/// The reference goes over the same ground as the take: it was given by the user.
	bool referenceOnGround;
	uint8_t* labels; // frameCount * legCount, soleContactLabel each
	bool* seams;     // frameCount, as in soleMeasureDef
} toolTake;

/// What a take is made from. All arrays are copied.
typedef struct toolTakeDef
{
	int32_t frameCount;
	double frameRate;
	float clipFloor;            // of the input
	const soleTransform* poses; // as placed
	const soleTransform* roots;
	const soleTransform* inputPoses; // the clip's own, in place
	/// Where the clip was moved: its way along the floor and its heading are the reference's.
	const soleTransform* inputRoots;
	const bool* seams; // NULL: none
} toolTakeDef;

/// Fails where memory for labels does, or where a pose is not usable.
bool toolMakeTake( const toolCharacter* character, const toolTakeDef* def, toolTake* take, toolError* error );
/// Rounds of a clip by itself on flat ground; take and reference are the same.
bool toolMakeClipTake( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, double fps,
    double rounds, toolTake* take, toolError* error );
void toolFreeTake( toolTake* take );

/// What a baked clip's extras say.
typedef struct toolBakeInfo
{
	char clip[256]; // that it was made from
	char method[64];
	char clips[1024]; // the file that has that clip; empty: the same
	double fps;
	int32_t frameCount;
	double rate; // of the clip's play
	double scale;
	int32_t travel; // node
} toolBakeInfo;

/// False where the clip was not baked, or by something else: nothing is wrong with that, there is no error.
bool toolReadBakeInfo( const toolClip* clip, toolBakeInfo* info );

/// The take of a baked clip of the character's own file.
/// @param base the clip that it was made from
bool toolRebuildTake( const toolCharacter* character, int32_t bakedClip, const toolBakeInfo* info,
    const toolBoundClip* base, toolTake* take, toolError* error );
/// Puts another clip of the same file, baked along the same way, in the reference's place. Labels stay.
bool toolReplaceReference( const toolCharacter* character, int32_t clip, toolTake* take, toolError* error );

/// @param referenceFigures may be NULL
bool toolMeasureTake( const toolCharacter* character, const toolTake* take, const soleTerrain* terrain,
    soleFigures* figures, soleFigures* referenceFigures, toolError* error );

/// The same with figures as others have published them.
bool toolMeasureTakePublished( const toolCharacter* character, const toolTake* take, const soleTerrain* terrain,
    solePublishedFigures* figures, solePublishedFigures* referenceFigures, toolError* error );

/// The take of what was just baked.
bool toolMakeBakeTake( const toolCharacter* character, const toolBakeResult* result, toolTake* take, toolError* error );

/// The furthest that a leg's end was from where the method wanted it, over labelled frames, m. Not a number where the
/// method does not tell.
double toolFindShortfall( const toolBakeResult* result, const toolTake* take );

/// toolMeasureTake() for what was just baked.
bool toolMeasureBake( const toolCharacter* character, const toolBakeResult* result, const soleTerrain* terrain,
    soleFigures* figures, soleFigures* referenceFigures, toolError* error );

#endif
