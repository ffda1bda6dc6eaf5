// SPDX-License-Identifier: MIT
// What a frame of one of the systems that Sole is compared with shows of itself, as a list of marks.
#include "baselines/ancestor_draw.h"
#include "glue.h"

int32_t soleWasm_DrawMethod( const soleWasmCharacter* c, uint32_t mask, soleWasmMark* marks, int32_t capacity );

int32_t soleWasm_DrawMethod( const soleWasmCharacter* c, uint32_t mask, soleWasmMark* marks, int32_t capacity )
{
	soleWasmMarks list = { .marks = marks, .capacity = capacity };
	soleDebugDraw draw = soleWasm_MakePen( &list, mask );
	soleDrawnAncestor drawn = {
		.rig = c->rig,
		.frame = &c->frame,
		.placed = c->placed,
		.probes = c->probes,
		.hits = c->hits,
		.probeCount = c->probeCount,
		.output = &c->output,
	};
	soleDrawAncestor( &draw, &drawn );
	return list.count;
}
