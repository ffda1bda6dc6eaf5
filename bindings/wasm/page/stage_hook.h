// SPDX-License-Identifier: MIT
// Put before src/place/place.c where the page's module that measures stages is built: stages call out of the module.
#ifndef SOLE_STAGE_HOOK_H
#define SOLE_STAGE_HOOK_H

void soleWasm_BeginStages( void ) __attribute__( ( import_module( "sole" ), import_name( "begin" ) ) );
void soleWasm_EndStage( const char* name ) __attribute__( ( import_module( "sole" ), import_name( "end" ) ) );

#define SOLE_STAGES_BEGIN() soleWasm_BeginStages()
#define SOLE_STAGE_END( name ) soleWasm_EndStage( name )

#endif
