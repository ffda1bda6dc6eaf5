// SPDX-License-Identifier: MIT
// The figures of the gates with their names, in the units in which they are shown: millimetres, degrees.
#include "test.h"

#include "scene_figures.h"

int32_t testListFigures( const testGates* g, testFigure figures[MOST_FIGURES] )
{
	const testFigure list[] = {
		{ "G1", test_g1, 1e3, "%6.1f", &g->slide },
		{ "G2", test_g2, 1e3, "%6.1f", &g->depth },
		{ "sw", test_g2, 1e3, "%6.1f", &g->swingDepth },
		{ "G3", test_g3, 1e3, "%6.1f", &g->gap },
		{ "flat", test_gFlat, 1e3, "%6.1f", &g->flatGap },
		{ "G4", test_g4, 1e3, "%6.1f", &g->move },
		{ "deg", test_g4, 1.0, "%5.1f", &g->turn },
		{ "G5", test_g5, 1e3, "%5.2f", &g->rest },
		{ "deg", test_g5, 1.0, "%5.2f", &g->restTurn },
		{ "G6", test_g6, 1.0, "%3.0f", &g->folded },
		{ "pl", test_g6, 1.0, "%3.0f", &g->plane },
		{ "G7", test_g7, 1.0, "%6.3f", &g->reach },
		{ "in", test_gInput, 1e3, "%6.1f", &g->away },
		{ "deg", test_gInput | test_gLevel, 1.0, "%5.1f", &g->awayTurn },
		{ "ov", test_gOver, 1.0, "%4.2f", &g->overhang },
		{ "sil", test_gSilent, 1e3, "%5.1f", &g->silent },
		{ "yaw", test_gYaw, 1.0, "%4.0f", &g->yaw },
		{ "ap", test_gApart, 1e3, "%5.0f", &g->overlap },
		{ "kn", test_gKnee, 1.0, "%4.2f", &g->kneeRate },
		{ "er", test_gTrue, 1e3, "%5.1f", &g->reported },
	};
	int32_t count = (int32_t)( sizeof list / sizeof list[0] );
	assert_true( count <= MOST_FIGURES );
	memcpy( figures, list, sizeof list );
	return count;
}

void testWriteFigures( const testGates* g, uint32_t gates, char* text, size_t size )
{
	testFigure figures[MOST_FIGURES];
	int32_t count = testListFigures( g, figures );
	size_t length = 0;
	text[0] = 0;
	for ( int32_t i = 0; i < count && length < size; ++i )
	{
		if ( ( gates & figures[i].gates ) != 0 )
		{
			length += (size_t)snprintf( text + length, size - length, "%s%s %.4g", length > 0 ? ", " : "",
			    figures[i].label, figures[i].unit * figures[i].worst->value );
		}
	}
}
