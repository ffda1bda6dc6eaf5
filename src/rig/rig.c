// SPDX-License-Identifier: MIT
// Bakes a rig definition: lists the joints to evaluate, and takes all geometry from character space in the bind pose to
// the local space of the joint that carries it. Set-up code, in character space.
#include "rig/rig.h"

#include "base/core.h"

#include <string.h>

#define MOST_CHILDREN 32 // of the pelvis that are looked at
#define MOST_DEPTH 64    // of joints below them

soleLegDef soleDefaultLegDef( void )
{
	soleLegDef def = { 0 };
	for ( int32_t i = 0; i < SOLE_MAX_LEG_JOINTS; ++i )
	{
		def.joints[i] = SOLE_NONE;
	}
	for ( int32_t i = 0; i < SOLE_MAX_TOE_JOINTS; ++i )
	{
		def.toes[i] = SOLE_NONE;
	}
	def.detachedFoot = SOLE_NONE;
	def.ankleLimits = ( soleAnkleLimits ){ 0.8f, 0.87f, 0.61f, 0.35f, 0.52f };
	return def;
}

soleRigDef soleDefaultRigDef( void )
{
	soleRigDef def = { 0 };
	def.pelvis = SOLE_NONE;
	def.up = soleVec( 0.0f, 1.0f, 0.0f );
	def.forward = soleVec( 0.0f, 0.0f, 1.0f );
	for ( int32_t i = 0; i < SOLE_MAX_LEGS; ++i )
	{
		def.legs[i] = soleDefaultLegDef();
	}
	def.internalValue = SOLE_COOKIE;
	return def;
}

// ---------------------------------------------------------------------------------------------------------- slots

static int16_t soleFindSlot( const soleRig* rig, int32_t joint )
{
	for ( int32_t i = 0; i < rig->slotCount; ++i )
	{
		if ( rig->slotJoints[i] == joint )
		{
			return (int16_t)i;
		}
	}
	return SOLE_NONE;
}

/// Adds a joint and all above it, parents first. @return its slot, or SOLE_NONE where there are too many.
static int16_t soleAddSlot( soleRig* rig, int32_t joint )
{
	int32_t missing[SOLE_MAX_SLOTS];
	int32_t count = 0;
	int16_t parent = SOLE_NONE;
	for ( int32_t j = joint; j != SOLE_NONE; j = rig->parents[j] )
	{
		parent = soleFindSlot( rig, j );
		if ( parent != SOLE_NONE )
		{
			break;
		}
		if ( rig->slotCount + count >= SOLE_MAX_SLOTS )
		{
			return SOLE_NONE;
		}
		missing[count++] = j;
	}
	while ( count > 0 )
	{
		int32_t slot = rig->slotCount++;
		rig->slotJoints[slot] = missing[--count];
		rig->slotParents[slot] = parent;
		parent = (int16_t)slot;
	}
	return parent;
}

static soleTransform soleBindWorld( const soleRigDef* def, int32_t joint )
{
	soleTransform t = def->bindPose[joint];
	t.rotation = soleNormalizeQuat( t.rotation );
	for ( int32_t j = def->parents[joint]; j != SOLE_NONE; j = def->parents[j] )
	{
		soleTransform parent = def->bindPose[j];
		parent.rotation = soleNormalizeQuat( parent.rotation );
		t = soleMulTransform( parent, t );
	}
	return t;
}

// ----------------------------------------------------------------------------------------------------------- legs

/// Positions of the chain in the bind pose, the virtual ankle last where there is one. @return how many.
static int32_t soleChainPoints( const soleRigDef* def, const soleLegDef* leg, soleVec3 points[SOLE_MAX_LEG_JOINTS + 1] )
{
	int32_t count = leg->jointCount;
	for ( int32_t i = 0; i < count; ++i )
	{
		points[i] = soleBindWorld( def, leg->joints[i] ).translation;
	}
	if ( leg->hasVirtualAnkle )
	{
		points[count++] = leg->virtualAnkle;
	}
	return count;
}

/// The joint that bends: of a chain of two bones the one between, of longer ones the one nearest to half of the length.
/// A single bone does not bend: 0.
static int16_t soleChooseKnee( const soleVec3* points, int32_t count, float length )
{
	int16_t knee = 0;
	float best = length;
	float along = 0.0f;
	for ( int32_t i = 1; i < count - 1; ++i )
	{
		along += soleDistance( points[i - 1], points[i] );
		float off = along > 0.5f * length ? along - 0.5f * length : 0.5f * length - along;
		if ( off < best )
		{
			best = off;
			knee = (int16_t)i;
		}
	}
	return knee;
}

/// The hinge axis from the bend of the bind pose; zero where it is straighter than a degree.
static soleVec3 soleHingeFromBend( const soleVec3* points, int32_t count, int32_t knee )
{
	soleVec3 thigh = soleSub( points[knee], points[0] );
	soleVec3 shin = soleSub( points[count - 1], points[knee] );
	soleVec3 n = soleCross( thigh, shin );
	float limit = 0.017f * soleLength( thigh ) * soleLength( shin );
	return soleLength( n ) > limit ? n : soleVec( 0.0f, 0.0f, 0.0f );
}

static soleRange soleMakeRange( float low, float high )
{
	return ( soleRange ){ soleHalfFromAngle( low ), soleHalfFromAngle( high ) };
}

static void soleBakeFoot( const soleRigDef* def, soleRigLeg* leg, soleVec3 ankle )
{
	const soleLegDef* d = &leg->def;
	int32_t foot = d->detachedFoot != SOLE_NONE ? d->detachedFoot : d->joints[d->jointCount - 1];
	soleTransform footWorld = soleBindWorld( def, foot );
	leg->footBind = footWorld;
	leg->toeBind = d->toeCount > 0 ? soleBindWorld( def, d->toes[0] ) : footWorld;
	leg->heel = soleInvTransformPoint( footWorld, d->sole.heel );
	leg->toe = soleInvTransformPoint( footWorld, d->sole.toe );
	leg->inner = soleInvTransformPoint( footWorld, d->sole.inner );
	leg->outer = soleInvTransformPoint( footWorld, d->sole.outer );
	leg->foreBall = soleInvTransformPoint( leg->toeBind, d->sole.ball );
	leg->foreToe = soleInvTransformPoint( leg->toeBind, d->sole.toe );
	leg->foreInner = soleInvTransformPoint( leg->toeBind, d->sole.inner );
	leg->foreOuter = soleInvTransformPoint( leg->toeBind, d->sole.outer );
	leg->pivot = soleInvTransformPoint( footWorld, d->toeCount > 0 ? leg->toeBind.translation : d->sole.ball );

	// The sole's own plane need not be level in the bind pose (a bind pose may be a stride): up is that of the sole.
	soleVec3 bodyUp = soleNormalizeOr( def->up, soleVec( 0.0f, 1.0f, 0.0f ) );
	soleVec3 bodyForward = soleNormalizeOr( soleReject( def->forward, bodyUp ), soleAnyOrthogonal( bodyUp ) );
	soleVec3 along = soleSub( d->sole.toe, d->sole.heel );
	soleVec3 across = soleSub( d->sole.outer, d->sole.inner );
	soleVec3 forward = soleNormalizeOr( along, bodyForward );
	soleVec3 up = soleNormalizeOr( soleReject( soleCross( along, across ), forward ), soleReject( bodyUp, forward ) );
	up = soleNormalizeOr( soleDot( up, bodyUp ) < 0.0f ? soleNeg( up ) : up, bodyUp );
	soleVec3 side = soleCross( forward, up );
	leg->footUp = soleInvRotate( footWorld.rotation, up );
	leg->footForward = soleInvRotate( footWorld.rotation, forward );
	leg->footSide = soleInvRotate( footWorld.rotation, side );

	leg->heelBehind = soleMaxF( soleDot( soleSub( d->sole.ball, d->sole.heel ), forward ), 0.0f );
	leg->toeAhead = soleMaxF( soleDot( soleSub( d->sole.toe, d->sole.ball ), forward ), 0.0f );
	leg->innerSide = soleDot( soleSub( d->sole.inner, d->sole.ball ), side );
	leg->outerSide = soleDot( soleSub( d->sole.outer, d->sole.ball ), side );
	leg->ankleHeight = soleDot( soleSub( ankle, d->sole.ball ), up );
	leg->ankleBehind = soleDot( soleSub( d->sole.ball, ankle ), forward );

	int32_t shin = d->joints[d->hasVirtualAnkle || d->jointCount < 2 ? d->jointCount - 1 : d->jointCount - 2];
	soleQuat shinRotation = soleBindWorld( def, shin ).rotation;
	// Neutral is the foot level under the body: its sole's up turned to the body's.
	soleQuat level = soleMulQuat( soleFromTo( up, bodyUp, forward ), footWorld.rotation );
	leg->neutral = soleMulQuat( soleConjugate( shinRotation ), level );

	soleAnkleLimits limits = d->ankleLimits;
	leg->pitch = soleMakeRange( -limits.plantarflexion, limits.dorsiflexion );
	// A positive roll leans the foot's up to its side vector; inversion leans it outwards.
	bool outwards = leg->outerSide >= leg->innerSide;
	leg->roll = outwards ? soleMakeRange( -limits.eversion, limits.inversion )
	                     : soleMakeRange( -limits.inversion, limits.eversion );
	leg->twist = soleMakeRange( -limits.twist, limits.twist );
}

static soleResult soleBakeLeg( const soleRigDef* def, soleRig* rig, int32_t index, soleMessage* message )
{
	soleRigLeg* leg = rig->legs + index;
	leg->def = def->legs[index];
	if ( leg->def.name != NULL )
	{
		strncpy( leg->name, leg->def.name, sizeof leg->name - 1 );
	}
	leg->def.name = leg->name;

	soleVec3 points[SOLE_MAX_LEG_JOINTS + 1];
	int32_t count = soleChainPoints( def, &leg->def, points );
	for ( int32_t i = 1; i < count; ++i )
	{
		leg->length += soleDistance( points[i - 1], points[i] );
	}
	if ( !( leg->length > 1e-6f ) )
	{
		soleSetMessage( message, "legs[%d]: '%s' has no length in the bind pose: check its joints and the bind pose",
		    index, leg->name );
		return sole_invalidDefinition;
	}
	if ( soleIsFinite( leg->length ) == false )
	{
		soleSetMessage(
		    message, "legs[%d]: '%s' is too long in the bind pose for a float: check its scale", index, leg->name );
		return sole_invalidDefinition;
	}
	leg->kneeIndex = soleChooseKnee( points, count, leg->length );
	soleVec3 hinge = leg->def.hinge;
	if ( !( soleDot( hinge, hinge ) > 1e-12f ) && leg->kneeIndex > 0 )
	{
		hinge = soleHingeFromBend( points, count, leg->kneeIndex );
		if ( !( soleDot( hinge, hinge ) > 0.0f ) )
		{
			soleSetMessage( message,
			    "legs[%d].hinge: is zero and the bind pose of '%s' is straight: give the axis its knee bends about",
			    index, leg->name );
			return sole_invalidDefinition;
		}
	}
	leg->def.hinge = soleNormalizeOr( hinge, soleVec( 1.0f, 0.0f, 0.0f ) );
	leg->hinge = soleInvRotate( soleBindWorld( def, leg->def.joints[0] ).rotation, leg->def.hinge );
	soleVec3 ankle = points[count - 1];
	leg->virtualAnkle = soleInvTransformPoint( soleBindWorld( def, leg->def.joints[leg->def.jointCount - 1] ), ankle );
	soleBakeFoot( def, leg, ankle );

	bool fits = true;
	for ( int32_t i = 0; i < leg->def.jointCount; ++i )
	{
		leg->slots[i] = soleAddSlot( rig, leg->def.joints[i] );
		fits = fits && leg->slots[i] != SOLE_NONE;
	}
	leg->footSlot = leg->slots[leg->def.jointCount - 1];
	if ( leg->def.detachedFoot != SOLE_NONE )
	{
		leg->footSlot = soleAddSlot( rig, leg->def.detachedFoot );
		fits = fits && leg->footSlot != SOLE_NONE;
		for ( int32_t j = rig->parents[leg->def.detachedFoot]; j != SOLE_NONE; j = rig->parents[j] )
		{
			leg->footBelowPelvis = leg->footBelowPelvis || j == def->pelvis;
		}
	}
	leg->toeSlot = SOLE_NONE;
	if ( leg->def.toeCount > 0 )
	{
		leg->toeSlot = soleAddSlot( rig, leg->def.toes[0] );
		fits = fits && leg->toeSlot != SOLE_NONE;
	}
	if ( fits == false )
	{
		soleSetMessage( message,
		    "legs[%d]: more than %d joints lie between the skeleton's root and the feet: use fewer", index,
		    SOLE_MAX_SLOTS );
		return sole_invalidDefinition;
	}
	return sole_success;
}

/// The pelvis's child that leads to no leg and carries most joints, the first of equals.
static int32_t soleFindSpine( const soleRig* rig )
{
	int32_t children[MOST_CHILDREN];
	int32_t carried[MOST_CHILDREN];
	int32_t count = 0;
	int32_t best = SOLE_NONE;
	for ( int32_t i = 0; i < rig->jointCount; ++i )
	{
		int32_t child = i;
		for ( int32_t k = 0; k < MOST_DEPTH && child != SOLE_NONE && rig->parents[child] != rig->pelvis; ++k )
		{
			child = rig->parents[child];
		}
		if ( child == SOLE_NONE || rig->parents[child] != rig->pelvis || soleFindSlot( rig, child ) != SOLE_NONE )
		{
			continue;
		}
		int32_t k = 0;
		while ( k < count && children[k] != child )
		{
			++k;
		}
		if ( k == count && count < MOST_CHILDREN )
		{
			children[count] = child;
			carried[count] = 0;
			++count;
		}
		if ( k < count )
		{
			++carried[k];
			best = best == SOLE_NONE || carried[k] > carried[best] ? k : best;
		}
	}
	return best == SOLE_NONE ? SOLE_NONE : children[best];
}

soleResult soleCreateRig(
    const soleRigDef* def, const soleAllocator* allocator, soleRig** rigOut, soleMessage* message )
{
	SOLE_ASSERT( rigOut != NULL );
	if ( rigOut == NULL )
	{
		return sole_invalidDefinition;
	}
	*rigOut = NULL;
	soleResult result = soleRigDef_Validate( def, message );
	if ( result != sole_success )
	{
		return result;
	}
	size_t byteCount = sizeof( soleRig ) + sizeof( int32_t ) * (size_t)def->jointCount;
	soleRig* rig = soleAlloc( allocator, byteCount );
	if ( rig == NULL )
	{
		soleSetMessage( message, "out of memory: %zu bytes were asked for", byteCount );
		return sole_outOfMemory;
	}
	rig->byteCount = byteCount;
	if ( allocator != NULL )
	{
		rig->allocator = *allocator;
		rig->allocatorOrNull = &rig->allocator;
	}
	rig->jointCount = def->jointCount;
	rig->parents = (int32_t*)( rig + 1 );
	memcpy( rig->parents, def->parents, sizeof( int32_t ) * (size_t)def->jointCount );
	rig->pelvis = def->pelvis;
	rig->up = soleNormalizeOr( def->up, soleVec( 0.0f, 1.0f, 0.0f ) );
	rig->forward = soleNormalizeOr( soleReject( def->forward, rig->up ), soleAnyOrthogonal( rig->up ) );
	soleFillSettingRanges( &rig->settingRanges );
	rig->legCount = def->legCount;
	rig->pelvisSlot = soleAddSlot( rig, def->pelvis );
	if ( rig->pelvisSlot == SOLE_NONE )
	{
		soleSetMessage( message, "pelvis: more than %d joints lie above it: use fewer", SOLE_MAX_SLOTS );
		result = sole_invalidDefinition;
	}
	for ( int32_t i = 0; i < def->legCount && result == sole_success; ++i )
	{
		result = soleBakeLeg( def, rig, i, message );
	}
	if ( result != sole_success )
	{
		soleDestroyRig( rig );
		return result;
	}
	rig->spine = soleFindSpine( rig );
	*rigOut = rig;
	return sole_success;
}

void soleDestroyRig( soleRig* rig )
{
	if ( rig == NULL )
	{
		return;
	}
	soleAllocator allocator = rig->allocator;
	soleFree( rig->allocatorOrNull != NULL ? &allocator : NULL, rig, rig->byteCount );
}

// ------------------------------------------------------------------------------------------------------- accessors

static bool soleIsLeg( const soleRig* rig, int32_t leg )
{
	bool valid = rig != NULL && leg >= 0 && leg < rig->legCount;
	SOLE_ASSERT( valid && "a leg of this rig" );
	return valid;
}

int32_t soleRig_GetJointCount( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->jointCount : 0;
}

int32_t soleRig_GetParent( const soleRig* rig, int32_t joint )
{
	bool valid = rig != NULL && joint >= 0 && joint < rig->jointCount;
	SOLE_ASSERT( valid && "a joint of this rig" );
	return valid ? rig->parents[joint] : SOLE_NONE;
}

int32_t soleRig_GetLegCount( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->legCount : 0;
}

soleLegDef soleRig_GetLeg( const soleRig* rig, int32_t leg )
{
	return soleIsLeg( rig, leg ) ? rig->legs[leg].def : soleDefaultLegDef();
}

int32_t soleRig_GetPelvis( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->pelvis : SOLE_NONE;
}

int32_t soleRig_GetSpine( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->spine : SOLE_NONE;
}

soleVec3 soleRig_GetUp( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->up : soleVec( 0.0f, 1.0f, 0.0f );
}

soleVec3 soleRig_GetForward( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	return rig != NULL ? rig->forward : soleVec( 0.0f, 0.0f, 1.0f );
}

float soleRig_GetLegLength( const soleRig* rig, int32_t leg )
{
	return soleIsLeg( rig, leg ) ? rig->legs[leg].length : 0.0f;
}

int32_t soleRig_GetFootJoint( const soleRig* rig, int32_t leg, bool forePart )
{
	if ( !soleIsLeg( rig, leg ) )
	{
		return SOLE_NONE;
	}
	const soleRigLeg* l = rig->legs + leg;
	return rig->slotJoints[forePart && l->toeSlot != SOLE_NONE ? l->toeSlot : l->footSlot];
}

soleVec3 soleRig_ToFootSpace( const soleRig* rig, int32_t leg, soleVec3 bindPoint, bool forePart )
{
	if ( !soleIsLeg( rig, leg ) )
	{
		return bindPoint;
	}
	const soleRigLeg* l = rig->legs + leg;
	return soleInvTransformPoint( forePart && l->toeSlot != SOLE_NONE ? l->toeBind : l->footBind, bindPoint );
}
