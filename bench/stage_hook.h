// SPDX-License-Identifier: MIT
// Put before src/place/place.c where sole_bench_stages is built: it looks at the clock after each stage.
#ifndef BENCH_STAGE_HOOK_H
#define BENCH_STAGE_HOOK_H

void benchBeginStages( void );
void benchEndStage( const char* name );

#define SOLE_STAGES_BEGIN() benchBeginStages()
#define SOLE_STAGE_END( name ) benchEndStage( name )

#endif
