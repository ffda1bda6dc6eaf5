// SPDX-License-Identifier: MIT
// Shaded views of triangles: projected, sorted by depth, far ones painted first. View space: x right, y up, z towards
// the viewer's back, so depth grows with the distance from the eye.
//
// Sorting whole triangles by one depth each is wrong for large ones. Bodies are made of small triangles; a ground is
// cut into pieces, the finer the nearer a body is, and counts as a little farther away than it is, so that a sole that
// lies on the ground is painted over it.
#include "draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NEAREST 0.05f      // m before the eye
#define GROUND_PIECE 0.25f // m, longest edge
#define FINE_PIECE 0.12f
#define FINE_MARGIN 0.12f // m around a body
#define GROUND_BEHIND 0.03f
#define LARGEST_FACES 400000

typedef struct toolFace
{
	float x[3]; // pixels
	float y[3];
	float depth;
	float opacity;
	unsigned char color[3];
	int32_t order; // equal depths keep it, so the same scene is always the same text
} toolFace;

typedef struct toolPainter
{
	const toolSceneView* view;
	soleVec3 right;
	soleVec3 up;
	soleVec3 ahead;
	float scale; // pixels a metre at depth 1, or everywhere in parallel views
	int32_t faceCount;
	int32_t faceRoom;
	toolFace* faces;
	int32_t boxCount; // around each item that is no ground
	soleVec3* lows;
	soleVec3* highs;
} toolPainter;

static toolPainter toolMakePainter( const toolSceneView* view )
{
	toolPainter painter = { .view = view };
	painter.ahead = soleNormalizeOr( soleSub( view->target, view->eye ), soleVec( 0.0f, 0.0f, -1.0f ) );
	soleVec3 side = soleCross( painter.ahead, view->up );
	painter.right = soleNormalizeOr( side, soleAnyOrthogonal( painter.ahead ) );
	painter.up = soleCross( painter.right, painter.ahead );
	float height = view->fieldOfView > 0.0f ? 2.0f * tanf( 0.5f * view->fieldOfView ) : view->viewHeight;
	painter.scale = (float)view->box.height / soleMaxF( height, 1e-3f );
	painter.lows = toolAlloc( (size_t)view->itemCount + 1, sizeof( soleVec3 ) );
	painter.highs = toolAlloc( (size_t)view->itemCount + 1, sizeof( soleVec3 ) );
	return painter;
}

static void toolProject( const toolPainter* painter, soleVec3 p, float* x, float* y, float* depth )
{
	soleVec3 d = soleSub( p, painter->view->eye );
	const toolBox* box = &painter->view->box;
	*depth = soleDot( d, painter->ahead );
	float scale = painter->view->fieldOfView > 0.0f ? painter->scale / soleMaxF( *depth, NEAREST ) : painter->scale;
	*x = (float)( box->x + 0.5 * box->width ) + scale * soleDot( d, painter->right );
	*y = (float)( box->y + 0.5 * box->height ) - scale * soleDot( d, painter->up );
}

/// The transfer curve of sRGB (IEC 61966-2-1).
static unsigned char toolToSrgb( float linear )
{
	float c = soleClampF( linear, 0.0f, 1.0f );
	float s = c <= 0.0031308f ? 12.92f * c : 1.055f * powf( c, 1.0f / 2.4f ) - 0.055f;
	return (unsigned char)( 255.0f * s + 0.5f );
}

/// A key light over the viewer's left shoulder, and a sky that is brighter than the floor.
static void toolShade( const toolPainter* painter, soleVec3 normal, const float* color, unsigned char* shaded )
{
	soleVec3 toLight = soleMulAdd( soleMulAdd( soleNeg( painter->ahead ), -0.7f, painter->right ), 0.9f, painter->up );
	toLight = soleNormalizeOr( toLight, painter->up );
	float key = soleMaxF( 0.0f, soleDot( normal, toLight ) );
	float sky = 0.5f + 0.5f * soleDot( normal, soleNormalizeOr( painter->view->up, painter->up ) );
	float light = 0.72f * key + 0.20f + 0.22f * sky;
	for ( int32_t i = 0; i < 3; ++i )
	{
		shaded[i] = toolToSrgb( light * color[i] );
	}
}

static toolFace* toolNewFace( toolPainter* painter )
{
	if ( painter->faceCount == painter->faceRoom )
	{
		painter->faceRoom = 2 * painter->faceRoom + 1024;
		painter->faces = toolGrow( painter->faces, (size_t)painter->faceRoom, sizeof( toolFace ) );
	}
	toolFace* face = painter->faces + painter->faceCount;
	face->order = painter->faceCount++;
	return face;
}

static void toolPaintTriangle(
    toolPainter* painter, const soleVec3 p[3], const float* color, const toolSceneItem* item )
{
	toolFace face = { .opacity = soleClampF( item->opacity, 0.0f, 1.0f ) };
	float depths[3];
	for ( int32_t i = 0; i < 3; ++i )
	{
		toolProject( painter, p[i], face.x + i, face.y + i, depths + i );
		if ( !( depths[i] > NEAREST ) || !soleIsFinite( face.x[i] ) || !soleIsFinite( face.y[i] ) )
		{
			return;
		}
	}
	// Pixels go down, so a front face is clockwise in them.
	float area =
	    ( face.x[1] - face.x[0] ) * ( face.y[2] - face.y[0] ) - ( face.x[2] - face.x[0] ) * ( face.y[1] - face.y[0] );
	if ( !( area < 0.0f ) )
	{
		return;
	}
	soleVec3 normal = soleCross( soleSub( p[1], p[0] ), soleSub( p[2], p[0] ) );
	normal = soleNormalizeOr( soleScale( 1e3f, normal ), soleNeg( painter->ahead ) );
	face.depth = ( depths[0] + depths[1] + depths[2] ) / 3.0f + ( item->ground ? GROUND_BEHIND : 0.0f );
	toolShade( painter, normal, color, face.color );
	toolFace* place = toolNewFace( painter );
	face.order = place->order;
	*place = face;
}

static bool toolNearBody( const toolPainter* painter, const soleVec3 p[3] )
{
	for ( int32_t i = 0; i < painter->boxCount; ++i )
	{
		soleVec3 low = painter->lows[i];
		soleVec3 high = painter->highs[i];
		bool x = soleMaxF( p[0].x, soleMaxF( p[1].x, p[2].x ) ) > low.x &&
		    soleMinF( p[0].x, soleMinF( p[1].x, p[2].x ) ) < high.x;
		bool y = soleMaxF( p[0].y, soleMaxF( p[1].y, p[2].y ) ) > low.y &&
		    soleMinF( p[0].y, soleMinF( p[1].y, p[2].y ) ) < high.y;
		bool z = soleMaxF( p[0].z, soleMaxF( p[1].z, p[2].z ) ) > low.z &&
		    soleMinF( p[0].z, soleMinF( p[1].z, p[2].z ) ) < high.z;
		if ( x && y && z )
		{
			return true;
		}
	}
	return false;
}

/// Halves the longest edge until the pieces are small enough.
static void toolPaintGround(
    toolPainter* painter, const soleVec3 corners[3], const float* color, const toolSceneItem* item )
{
	soleVec3 stack[64][3];
	int32_t depth = 1;
	memcpy( stack[0], corners, sizeof stack[0] );
	while ( depth > 0 && painter->faceCount < LARGEST_FACES )
	{
		soleVec3 p[3];
		memcpy( p, stack[--depth], sizeof p );
		int32_t longest = 0;
		float edge = 0.0f;
		for ( int32_t i = 0; i < 3; ++i )
		{
			float length = soleDistance( p[i], p[( i + 1 ) % 3] );
			longest = length > edge ? i : longest;
			edge = soleMaxF( edge, length );
		}
		float limit = toolNearBody( painter, p ) ? FINE_PIECE : GROUND_PIECE;
		if ( !( edge > limit ) || depth + 2 > 64 )
		{
			toolPaintTriangle( painter, p, color, item );
			continue;
		}
		soleVec3 a = p[longest];
		soleVec3 b = p[( longest + 1 ) % 3];
		soleVec3 c = p[( longest + 2 ) % 3];
		soleVec3 middle = soleLerp( a, b, 0.5f );
		const soleVec3 halves[2][3] = { { a, middle, c }, { middle, b, c } };
		memcpy( stack[depth], halves, sizeof halves );
		depth += 2;
	}
}

static soleVec3 toolCorner( const toolTriangles* triangles, int32_t triangle, int32_t corner )
{
	const float* p = triangles->positions + 3 * triangles->indices[3 * triangle + corner];
	return soleVec( p[0], p[1], p[2] );
}

static void toolPaintItem( toolPainter* painter, const toolSceneItem* item )
{
	for ( int32_t i = 0; i < item->triangles->triangleCount; ++i )
	{
		soleVec3 p[3];
		for ( int32_t k = 0; k < 3; ++k )
		{
			p[k] = toolCorner( item->triangles, i, k );
		}
		const float* color = item->triangles->colors + 3 * i;
		if ( !soleVec3_IsFinite( p[0] ) || !soleVec3_IsFinite( p[1] ) || !soleVec3_IsFinite( p[2] ) )
		{
			continue;
		}
		if ( item->ground )
		{
			toolPaintGround( painter, p, color, item );
		}
		else
		{
			toolPaintTriangle( painter, p, color, item );
		}
	}
}

static void toolAddBox( toolPainter* painter, const toolTriangles* triangles )
{
	soleVec3 low = { 1e30f, 1e30f, 1e30f };
	soleVec3 high = { -1e30f, -1e30f, -1e30f };
	for ( int32_t i = 0; i < triangles->vertexCount; ++i )
	{
		const float* p = triangles->positions + 3 * i;
		low = soleVec( soleMinF( low.x, p[0] ), soleMinF( low.y, p[1] ), soleMinF( low.z, p[2] ) );
		high = soleVec( soleMaxF( high.x, p[0] ), soleMaxF( high.y, p[1] ), soleMaxF( high.z, p[2] ) );
	}
	soleVec3 margin = { FINE_MARGIN, FINE_MARGIN, FINE_MARGIN };
	painter->lows[painter->boxCount] = soleSub( low, margin );
	painter->highs[painter->boxCount++] = soleAdd( high, margin );
}

static int toolCompareFaces( const void* a, const void* b )
{
	const toolFace* p = a;
	const toolFace* q = b;
	if ( p->depth != q->depth )
	{
		return p->depth > q->depth ? -1 : 1;
	}
	return p->order < q->order ? -1 : 1;
}

static bool toolFaceInBox( const toolFace* face, const toolBox* box )
{
	float left = soleMinF( face->x[0], soleMinF( face->x[1], face->x[2] ) );
	float right = soleMaxF( face->x[0], soleMaxF( face->x[1], face->x[2] ) );
	float top = soleMinF( face->y[0], soleMinF( face->y[1], face->y[2] ) );
	float bottom = soleMaxF( face->y[0], soleMaxF( face->y[1], face->y[2] ) );
	return (double)right >= box->x && (double)left <= box->x + box->width && (double)bottom >= box->y &&
	    (double)top <= box->y + box->height;
}

static bool toolSameInk( const toolFace* a, const toolFace* b )
{
	return memcmp( a->color, b->color, sizeof a->color ) == 0 && a->opacity >= 1.0f && b->opacity >= 1.0f;
}

static int toolTenths( float x )
{
	return (int)lround( 10.0 * toolSvgNumber( (double)x ) );
}

/// Faces of one colour that follow one another make one path; in tenths of a pixel, since there are many.
static void toolWriteFaces( toolSvg* svg, const toolFace* faces, int32_t count, const toolBox* box )
{
	const toolFace* open = NULL;
	for ( int32_t i = 0; i < count; ++i )
	{
		const toolFace* face = faces + i;
		if ( toolFaceInBox( face, box ) == false )
		{
			continue;
		}
		if ( open == NULL || toolSameInk( open, face ) == false )
		{
			// A thin line of the same colour closes the seams that antialiasing leaves between neighbours; where a face
			// can be seen through, it would show.
			char color[8];
			snprintf( color, sizeof color, "#%02x%02x%02x", face->color[0], face->color[1], face->color[2] );
			toolSvgPrint( svg, "%s<path fill=\"%s\" ", open != NULL ? "\"/>\n" : "", color );
			face->opacity < 1.0f ? toolSvgPrint( svg, "fill-opacity=\"%.2f\"", (double)face->opacity )
			                     : toolSvgPrint( svg, "stroke=\"%s\"", color );
			toolSvgPrint( svg, " d=\"" );
			open = face;
		}
		int x = toolTenths( face->x[0] ), y = toolTenths( face->y[0] );
		toolSvgPrint( svg, "M%d %dl%d %d", x, y, toolTenths( face->x[1] ) - x, toolTenths( face->y[1] ) - y );
		toolSvgPrint( svg, " %d %dz", toolTenths( face->x[2] ) - toolTenths( face->x[1] ),
		    toolTenths( face->y[2] ) - toolTenths( face->y[1] ) );
	}
	toolSvgPrint( svg, "%s", open != NULL ? "\"/>\n" : "" );
}

void toolSvgScene( toolSvg* svg, const toolSceneView* view )
{
	toolPainter painter = toolMakePainter( view );
	for ( int32_t i = 0; i < view->itemCount; ++i )
	{
		if ( !view->items[i].ground && view->items[i].triangles->vertexCount > 0 )
		{
			toolAddBox( &painter, view->items[i].triangles );
		}
	}
	for ( int32_t i = 0; i < view->itemCount; ++i )
	{
		toolPaintItem( &painter, view->items + i );
	}
	if ( painter.faceCount > 0 )
	{
		qsort( painter.faces, (size_t)painter.faceCount, sizeof( toolFace ), toolCompareFaces );
	}
	int32_t id = toolSvgNewId( svg );
	toolSvgPrint( svg,
	    "<clipPath id=\"view%d\"><rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/></clipPath>\n"
	    "<g clip-path=\"url(#view%d)\"><g transform=\"scale(0.1)\" stroke-width=\"6\" stroke-linejoin=\"round\">\n",
	    (int)id, view->box.x, view->box.y, view->box.width, view->box.height, (int)id );
	toolWriteFaces( svg, painter.faces, painter.faceCount, &view->box );
	toolSvgPrint( svg, "</g></g>\n" );
	free( painter.faces );
	free( painter.lows );
	free( painter.highs );
}
