// SPDX-License-Identifier: MIT
// Optional ground for those without physics: triangle meshes, height fields and planes, asked with rays and swept
// spheres, still or moving. Knows nothing of feet: a probe and a hit are all it shares with the rest. Immutable once
// made but for soleRefitGround(), any number of threads may cast at once. Results do not depend on the order of
// triangles but for ties, which go to the lower index. No ray slips between triangles that share their corners,
// whatever its direction.
#ifndef SOLE_GROUND_H
#define SOLE_GROUND_H

#include "sole/types.h"

/// Triangles. A face is met only from its front, where its corners run counter clockwise: a ray from behind passes, and
/// so does a sphere whose middle starts behind it. So a probe that starts inside a closed mesh goes out unnoticed.
typedef struct soleGroundMesh
{
	const float* vertices; // x, y, z of each vertex, world
	int32_t vertexCount;
	int32_t vertexStride;    // in bytes. default 12
	const uint32_t* indices; // three a triangle
	int32_t triangleCount;
	/// Per triangle the layers it is on. NULL: all of them are on `layer`.
	const uint32_t* triangleLayers;
	uint32_t layer;  // default 1
	int32_t surface; // what hits report. default SOLE_NONE
	/// Also meet back faces: for meshes with careless winding. The reported normal is turned against the probe; where a
	/// sphere touches at its start, towards the middle of the sphere.
	bool twoSided;
} soleGroundMesh;

/// Heights over a regular grid. The grid spans origin + i cellX axisX + j cellZ axisZ + height up, i < countX,
/// j < countZ, axes orthonormal, mirrored or not. Each cell is two triangles, split along the diagonal from (i, j) to
/// (i + 1, j + 1), met from above only.
typedef struct soleHeightField
{
	soleVec3 origin;
	soleVec3 axisX;
	soleVec3 axisZ;
	soleVec3 up;
	float cellX; // > 0
	float cellZ;
	int32_t countX; // >= 2
	int32_t countZ;
	const float* heights; // countX * countZ, row by row along X; NaN is a hole
	uint32_t layer;
	int32_t surface;
} soleHeightField;

/// All points with dot( point, normal ) <= offset are solid: a probe that starts there has started inside.
typedef struct soleGroundPlane
{
	soleVec3 normal; // unit
	float offset;
	uint32_t layer;
	int32_t surface;
} soleGroundPlane;

/// Start from soleDefaultGroundDef(). The arrays are copied.
typedef struct soleGroundDef
{
	const soleGroundMesh* meshes;
	int32_t meshCount;
	const soleHeightField* heightFields;
	int32_t heightFieldCount;
	const soleGroundPlane* planes;
	int32_t planeCount;
	int32_t internalValue;
} soleGroundDef;

typedef struct soleGround soleGround;

SOLE_API soleGroundDef soleDefaultGroundDef( void );
SOLE_API soleGroundMesh soleDefaultGroundMesh( void );
SOLE_API soleHeightField soleDefaultHeightField( void );
SOLE_API soleGroundPlane soleDefaultGroundPlane( void );

/// Refuses vertices that are not finite and indices out of range; drops triangles without area.
SOLE_API soleResult soleCreateGround(
    const soleGroundDef* def, const soleAllocator* allocator, soleGround** ground, soleMessage* message );
/// Takes over where everything is now, in place and without memory: the definition that the ground was made of with
/// other vertices, heights or planes, its counts unchanged. Cheaper than a new ground, and as good for as long as
/// neighbours stay neighbours. Triangles that had no area at first stay left out; layers and surfaces are those of the
/// first time. Not while others cast.
/// @return sole_invalidDefinition where the definition is not usable or of other counts: nothing has changed then
SOLE_API soleResult soleRefitGround( soleGround* ground, const soleGroundDef* def, soleMessage* message );
/// NULL is allowed.
SOLE_API void soleDestroyGround( soleGround* ground );

/// Nearest hit of one probe. A probe that is not finite or has no length misses, as does every probe of a NULL ground.
/// The normal is always that of a face, never one between two: where a sphere meets an edge or a corner, of the face
/// that its way meets most squarely. A sphere that touches at its start has started inside; of all it touches, the
/// nearest is reported.
SOLE_API soleHit soleCastProbe( const soleGround* ground, const soleProbe* probe );

/// The same for many: hits[i] answers probes[i]. Faster than one by one, as they wait for memory together; the more so
/// the closer together those are that follow each other.
SOLE_API void soleCastProbes( const soleGround* ground, const soleProbe* probes, int32_t count, soleHit* hits );

/// A ground that moves as a whole: a lift, a turntable, a vehicle. Where it is now and how it moves.
typedef struct soleGroundPiece
{
	/// NULL: not there.
	const soleGround* ground;
	/// From the space in which the ground was given to the world: rotation and place; the scale is not read.
	soleTransform transform;
	/// Of the place transform.translation, world.
	soleVec3 velocity_w;
	/// Turns about this at as many radians a second as it is long, right-handed; world.
	soleVec3 spin_w;
	/// What hits report. SOLE_NONE: what the ground itself says.
	int32_t surface;
} soleGroundPiece;

/// Nearest hit of one probe among pieces, each asked in its own space; ties go to the lower index. The velocity of a
/// hit is that of its piece at the point.
SOLE_API soleHit soleCastPieces( const soleGroundPiece* pieces, int32_t count, const soleProbe* probe );

/// The box around everything but planes. Empty ground: lower above upper.
SOLE_API void soleGround_GetBounds( const soleGround* ground, soleVec3* lower, soleVec3* upper );
SOLE_API int32_t soleGround_GetTriangleCount( const soleGround* ground );

#endif
