// SPDX-License-Identifier: MIT
// Pictures: well-formed whatever goes in, no number that is none, what is nearer is painted later.
#include "test.h"

#include "draw.h"
#include "mannequin.h"

#include <ctype.h>
#include <math.h>

/// Every tag closes in its order, attributes are quoted, text holds no bare brackets or ampersands.
static void checkWellFormed( const char* text )
{
	char open[32][32];
	int depth = 0;
	int elements = 0;
	const char* c = text;
	while ( *c != '\0' )
	{
		if ( *c == '&' )
		{
			assert_true( strncmp( c, "&amp;", 5 ) == 0 || strncmp( c, "&lt;", 4 ) == 0 ||
			    strncmp( c, "&gt;", 4 ) == 0 || strncmp( c, "&quot;", 6 ) == 0 );
		}
		assert_true( *c != '>' );
		if ( *c != '<' )
		{
			assert_true( (unsigned char)*c >= 0x20 || *c == '\n' );
			++c;
			continue;
		}
		bool closing = c[1] == '/';
		char name[32] = { 0 };
		int length = 0;
		for ( c += closing ? 2 : 1; isalpha( (unsigned char)*c ) && length < 31; ++c )
		{
			name[length++] = *c;
		}
		assert_true( length > 0 );
		bool quoted = false;
		for ( ; *c != '\0' && ( quoted || *c != '>' ); ++c )
		{
			quoted = *c == '"' ? !quoted : quoted;
			assert_true( *c != '<' );
		}
		assert_true( *c == '>' && !quoted );
		if ( closing )
		{
			assert_true( depth > 0 );
			assert_string_equal( open[--depth], name );
		}
		else if ( c[-1] != '/' )
		{
			assert_true( depth < 32 );
			strcpy( open[depth++], name );
		}
		++elements;
		++c;
	}
	assert_int_equal( depth, 0 );
	assert_true( elements > 1 );
	assert_null( strstr( text, "nan" ) );
	assert_null( strstr( text, "inf" ) );
}

static int countOf( const char* text, const char* what )
{
	int count = 0;
	for ( const char* c = strstr( text, what ); c != NULL; c = strstr( c + 1, what ) )
	{
		++count;
	}
	return count;
}

static void testTextIsEscaped( void** state )
{
	(void)state;
	toolSvg* svg = toolSvgBegin( 100, 50 );
	toolSvgText( svg, 1, 2, 12, tool_anchorStart, "a < b & \"c\" > d\x01\n" );
	toolSvgText( svg, (double)NAN, (double)INFINITY, 12, tool_anchorEnd, "" );
	char* text = toolSvgEnd( svg );
	checkWellFormed( text );
	assert_non_null( strstr( text, "a &lt; b &amp; &quot;c&quot; &gt; d" ) );
	free( text );
}

static void testPlot( void** state )
{
	(void)state;
	float x[5] = { 0, 1, 2, 3, 4 };
	float y[5] = { 0.0f, 0.5f, NAN, 0.2f, -0.1f };
	const toolSeries series[2] = { { .name = "none", .count = 5, .x = x, .y = y },
		{ .name = "sole <&>", .color = "#123456", .dashed = true, .count = 5, .x = x, .y = x } };
	const toolInterval intervals[3] = { { 0.5f, 1.5f }, { 3.5f, 9.0f }, { 20.0f, 30.0f } };
	toolPlot plot = { .box = { 0, 0, 600, 300 },
		.title = "Left foot",
		.xLabel = "time, s",
		.yLabel = "height, m",
		.seriesCount = 2,
		.series = series,
		.intervalCount = 3,
		.intervals = intervals,
		.intervalName = "planted" };
	toolSvg* svg = toolSvgBegin( 600, 300 );
	toolSvgPlot( svg, &plot );
	char* text = toolSvgEnd( svg );
	checkWellFormed( text );
	// Two planted intervals are in view, and the legend has its own patch; the gap starts the line anew.
	assert_int_equal( countOf( text, "fill-opacity=\"0.14\"" ), 2 );
	assert_int_equal( countOf( text, "fill-opacity=\"0.25\"" ), 1 );
	assert_non_null( strstr( text, "#123456" ) );
	assert_non_null( strstr( text, "sole &lt;&amp;&gt;" ) );
	free( text );
}

static void testPlotsWithNothingToShow( void** state )
{
	(void)state;
	float x[2] = { NAN, INFINITY };
	float same[2] = { 3.0f, 3.0f };
	const toolSeries series[2] = { { .count = 2, .x = x, .y = x }, { .count = 2, .x = same, .y = same } };
	for ( int32_t count = 0; count <= 2; ++count )
	{
		toolPlot plot = { .box = { 0, 0, 300, 200 }, .seriesCount = count, .series = series };
		toolSvg* svg = toolSvgBegin( 300, 200 );
		toolSvgPlot( svg, &plot );
		char* text = toolSvgEnd( svg );
		checkWellFormed( text );
		assert_true( strlen( text ) < 20000 );
		free( text );
	}
}

static const float s_red[3] = { 1.0f, 0.0f, 0.0f };
static const float s_blue[3] = { 0.0f, 0.0f, 1.0f };

static toolTriangles makeFacing( float z, const float color[3] )
{
	float positions[] = { -1, -1, z, 1, -1, z, 0, 1, z };
	uint32_t indices[] = { 0, 1, 2 };
	toolTriangles triangles = { 0 };
	toolAddTriangles( &triangles, positions, 3, indices, 1, color );
	return triangles;
}

/// Seen from +z. @return the picture
static char* drawItems( const toolSceneItem* items, int32_t count, float fieldOfView )
{
	toolSceneView view = { .box = { 0, 0, 200, 200 },
		.eye = { 0, 0, 6 },
		.up = { 0, 1, 0 },
		.viewHeight = 4.0f,
		.fieldOfView = fieldOfView,
		.itemCount = count,
		.items = items };
	toolSvg* svg = toolSvgBegin( 200, 200 );
	toolSvgScene( svg, &view );
	char* text = toolSvgEnd( svg );
	checkWellFormed( text );
	return text;
}

static void testNearerIsPaintedLater( void** state )
{
	(void)state;
	toolTriangles nearer = makeFacing( 1.0f, s_red );
	toolTriangles farther = makeFacing( -1.0f, s_blue );
	toolSceneItem items[2] = { { &nearer, 1.0f, false }, { &farther, 1.0f, false } };
	for ( int32_t i = 0; i < 2; ++i )
	{
		char* text = drawItems( items, 2, i == 0 ? 0.0f : 0.6f );
		const char* red = strstr( text, "0000\" stroke" );
		const char* blue = strstr( text, "fill=\"#0000" );
		assert_non_null( red );
		assert_non_null( blue );
		assert_true( blue < red );
		free( text );
	}
	toolFreeTriangles( &nearer );
	toolFreeTriangles( &farther );
}

static void testWhatIsNotSeen( void** state )
{
	(void)state;
	toolTriangles behindEye = makeFacing( 7.0f, s_red );
	toolTriangles away = makeFacing( 0.0f, s_red );
	uint32_t first = away.indices[0];
	away.indices[0] = away.indices[1];
	away.indices[1] = first;
	toolTriangles broken = makeFacing( 0.0f, s_red );
	broken.positions[4] = NAN;
	toolSceneItem items[3] = { { &behindEye, 1.0f, false }, { &away, 1.0f, false }, { &broken, 1.0f, true } };
	char* text = drawItems( items, 3, 0.6f );
	assert_int_equal( countOf( text, "<path" ), 0 );
	free( text );
	toolFreeTriangles( &behindEye );
	toolFreeTriangles( &away );
	toolFreeTriangles( &broken );
}

/// A ground of two large triangles is cut, finer where a body stands, and covers the same as before.
static void testGroundIsCut( void** state )
{
	(void)state;
	toolTriangles ground = makeFacing( -0.05f, s_blue );
	toolTriangles body = makeFacing( 0.0f, s_red );
	for ( int32_t i = 0; i < body.vertexCount * 3; ++i )
	{
		body.positions[i] *= 0.1f;
	}
	toolSceneItem items[2] = { { &ground, 1.0f, true }, { &body, 1.0f, false } };
	char* alone = drawItems( items, 1, 0.0f );
	char* both = drawItems( items, 2, 0.0f );
	assert_true( countOf( alone, "z" ) >= 64 );
	assert_true( countOf( both, "z" ) > countOf( alone, "z" ) + 10 );
	free( alone );
	free( both );
	toolFreeTriangles( &ground );
	toolFreeTriangles( &body );
}

static void testMannequin( void** state )
{
	(void)state;
	toolModel model;
	toolMakeMannequin( &model );
	soleTransform pose[64];
	for ( int32_t i = 0; i < model.nodeCount; ++i )
	{
		pose[i] = model.nodes[i].local;
	}
	toolTriangles body = { 0 };
	toolSkinModel( &model, pose, soleTransform_Identity(), &body );
	toolSceneItem item = { &body, 0.5f, false };
	char* text = drawItems( &item, 1, 0.7f );
	char* again = drawItems( &item, 1, 0.7f );
	int faces = countOf( text, "<path" );
	assert_true( faces > body.triangleCount / 3 && faces < body.triangleCount * 2 / 3 );
	assert_string_equal( text, again );
	free( text );
	free( again );
	toolFreeTriangles( &body );
	toolFreeModel( &model );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testTextIsEscaped ),
		cmocka_unit_test( testPlot ),
		cmocka_unit_test( testPlotsWithNothingToShow ),
		cmocka_unit_test( testNearerIsPaintedLater ),
		cmocka_unit_test( testWhatIsNotSeen ),
		cmocka_unit_test( testGroundIsCut ),
		cmocka_unit_test( testMannequin ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
