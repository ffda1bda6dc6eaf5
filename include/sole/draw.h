// SPDX-License-Identifier: MIT
// Shows what a frame of foot placement saw, decided and did, through the host's own callbacks: any engine, debugger or
// page that can draw a line can show it. Nothing here is needed to place feet; nothing is allocated or remembered.
//
// All places are in the frame's world, lengths in its unit.
#ifndef SOLE_DRAW_H
#define SOLE_DRAW_H

#include "sole/types.h"

/// What can be shown, each by itself.
typedef enum soleDrawCategory
{
	sole_drawAnimated = 1 << 0,  // the legs as animated
	sole_drawBones = 1 << 1,     // the legs as placed, with their joints
	sole_drawProbes = 1 << 2,    // what was asked of the ground
	sole_drawHits = 1 << 3,      // the answers, with normals
	sole_drawSweeps = 1 << 4,    // where probes start, and how wide they are
	sole_drawSole = 1 << 5,      // heel, ball, toe tip and edges of the placed feet
	sole_drawPlane = 1 << 6,     // the plane under each foot, filled as far as it is sure
	sole_drawLock = 1 << 7,      // where feet are held, and how far the animation may leave them
	sole_drawReach = 1 << 8,     // how far and how near each leg can reach
	sole_drawPelvis = 1 << 9,    // what the legs allow the pelvis, and where it went
	sole_drawFoothold = 1 << 10, // where feet in flight will land, and their way there
	sole_drawTarget = 1 << 11,   // where ankles were wanted, and how far they are from it
	sole_drawFlags = 1 << 12,    // why a leg is as it is, in words
	sole_drawCategoryForce32 = 0x7fffffff
} soleDrawCategory;

#define SOLE_DRAW_ALL ( ( 1u << 13 ) - 1u )

/// The colours of all that is drawn, 0xRRGGBB.
typedef enum soleDrawColor
{
	sole_colorAnimated = 0x8A919E,
	sole_colorBone = 0xF2F2EE,
	sole_colorJoint = 0xFFC857,
	sole_colorProbe = 0x4FA3D1,
	sole_colorMiss = 0xB0535E, // a probe that met nothing
	sole_colorHit = 0x2BD4C4,
	sole_colorInside = 0xE4572E, // a probe that started inside something
	sole_colorSweep = 0x3E7CB1,
	sole_colorSole = 0xFF8FA3,
	sole_colorPlane = 0x7BC950,
	sole_colorLock = 0xFF4F4F,
	sole_colorRelease = 0xFF9F80, // how far a lock goes
	sole_colorReach = 0xB388EB,
	sole_colorFold = 0x7A5BA6,
	sole_colorPelvis = 0xF5B700,
	sole_colorLimit = 0xC98F00, // what the legs allow it
	sole_colorFoothold = 0x9EE493,
	sole_colorWay = 0x5FB49C,
	sole_colorTarget = 0xFF66C4,
	sole_colorText = 0xFFFFFF,
	sole_colorForce32 = 0x7fffffff
} soleDrawColor;

/// What the host draws with. Every callback may be NULL: what needs it is then left out. Colours are soleDrawColor,
/// categories one bit of soleDrawCategory. Nothing that is not finite is handed out. Start from
/// soleDefaultDebugDraw().
typedef struct soleDebugDraw
{
	void ( *line )( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user );
	/// Points to `to_w`.
	void ( *arrow )( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user );
	void ( *circle )(
	    soleVec3 center_w, soleVec3 normal_w, float radius, uint32_t color, uint32_t category, void* user );
	void ( *sphere )( soleVec3 center_w, float radius, uint32_t color, uint32_t category, void* user );
	/// The text is gone after the call.
	void ( *text )( soleVec3 place_w, const char* text, uint32_t color, uint32_t category, void* user );
	void* user;
	/// soleDrawCategory bits that are shown. default SOLE_DRAW_ALL
	uint32_t mask;
	/// Tells a filled definition from a forgotten one. Do not set.
	int32_t internalValue;
} soleDebugDraw;

/// A frame as it went through soleGatherProbes() and soleSolve(). Its outcome need not be given: the same input gives
/// the same bits.
typedef struct soleDrawnFrame
{
	const soleRig* rig;
	const soleSettings* settings;
	/// As it was before soleSolve(): a copy that the host has kept. Is not changed.
	const soleState* state;
	const soleFrame* frame;
	/// May be NULL, as may the hits: what is drawn of them is then left out.
	const soleProbe* probes;
	const soleHit* hits;
	int32_t probeCount;
	int32_t hitCount;
} soleDrawnFrame;

/// One row of the table of what can be shown, for switches in an editor.
typedef struct soleDrawInfo
{
	soleDrawCategory category;
	const char* name; // "support plane"
	const char* text; // one sentence
} soleDrawInfo;

SOLE_API soleDebugDraw soleDefaultDebugDraw( void );
/// The table of categories, lowest bit first.
SOLE_API const soleDrawInfo* soleGetDrawInfos( int32_t* count );

/// Draws one frame of one character. A frame that soleSolve() passes through untouched draws nothing; so does a leg.
/// Solves the frame anew to see inside: costs as much as soleSolve() and 64 KiB of stack.
SOLE_API void soleDrawFrame( const soleDebugDraw* draw, const soleDrawnFrame* drawn );

#endif
