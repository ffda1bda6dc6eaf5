// SPDX-License-Identifier: MIT
// The mannequin on its walk, placed by Sole or by one of the systems that it is compared with. World: metres, y up.
#ifndef BENCH_WALKERS_H
#define BENCH_WALKERS_H

#include "bench.h"

#include "baselines/effector.h"
#include "baselines/homebrew.h"
#include "baselines/iksetting.h"
#include "baselines/ozz.h"
#include "motion.h"
#include "sole/ground.h"

#include <string.h>

#define BENCH_POSE_COUNT 64  // of one round of the walk
#define BENCH_MOST_PROBES 64 // of a biped

typedef struct benchWalk
{
	toolModel model;
	toolCharacter character;
	toolBoundClip clip;
	toolTravel travel;
	soleTransform* poses; // BENCH_POSE_COUNT * jointCount
} benchWalk;

/// One character in one frame, and what its method remembers.
typedef struct benchWalker
{
	const soleRig* rig;
	soleFrame frame;
	soleVec3 start;
	int32_t frameNumber;
	soleProbe probes[BENCH_MOST_PROBES];
	soleHit hits[BENCH_MOST_PROBES];
	int32_t probeCount;
	soleOutput output;
	union
	{
		struct
		{
			soleSettings settings;
			soleState state;
		} sole;
		struct
		{
			soleOzzSettings settings;
			soleOzzState state;
		} ozz;
		struct
		{
			soleHomebrewSettings settings;
			soleHomebrewState state;
		} homebrew;
		struct
		{
			soleIkSettingSettings settings;
			soleIkSettingState state;
		} ikSetting;
		struct
		{
			soleEffectorSettings settings;
			soleEffectorState state;
		} effector;
	};
} benchWalker;

/// Who places the feet.
typedef struct benchMethod
{
	const char* name;
	size_t stateOffset; // in a walker: what solve changes
	size_t stateSize;   // 0: as large as its rig needs
	void ( *start )( const benchWalk* walk, benchWalker* walker );
	int32_t ( *gather )( benchWalker* walker );
	void ( *solve )( benchWalker* walker );
} benchMethod;

/// The first is Sole.
extern const benchMethod benchMethods[];
extern const int32_t benchMethodCount;

/// Where a character of many sets out: 40 a row, and as often as it takes: they pass through each other.
soleVec3 benchGetStart( int32_t character );
/// Made once, lives as long as the program.
const benchWalk* benchGetWalk( void );
/// @param triangleCount 0: a flat plane
soleGround* benchMakeWalkGround( int64_t triangleCount );
void benchStartWalker(
    const benchWalk* walk, const benchMethod* method, soleVec3 start, int32_t frameNumber, benchWalker* walker );
/// The frame of a walker who set out at a place, so many frames later, on the ground that is there.
void benchPlaceWalker(
    const benchWalk* walk, const soleGround* ground, soleVec3 start, int32_t frameNumber, benchWalker* walker );
/// One frame further.
void benchStepWalker( const benchWalk* walk, const soleGround* ground, benchWalker* walker );

#endif
