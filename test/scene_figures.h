// SPDX-License-Identifier: MIT
// The figures of the gates as they are shown.
#ifndef TEST_SCENE_FIGURES_H
#define TEST_SCENE_FIGURES_H

#include "scene_gates.h"

typedef struct testFigure
{
	const char* label;
	uint32_t gates; // that it decides
	double unit;    // that many of the shown in one of the gates'
	const char* format;
	const testWorst* worst;
} testFigure;

#define MOST_FIGURES 24

int32_t testListFigures( const testGates* g, testFigure figures[MOST_FIGURES] );

/// Those that decide some gates, as "G2 5.2, sw 11".
void testWriteFigures( const testGates* g, uint32_t gates, char* text, size_t size );

#endif
