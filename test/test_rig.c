// SPDX-License-Identifier: MIT
// Rig definitions: what is refused, with which sentence; what is baked; memory.
#include "test.h"

#include "biped.h"

#include <stddef.h>

typedef void breakFcn( soleRigDef* def, testBiped* biped );

static void breakCookie( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->internalValue = 0;
}
static void breakJointCount( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->jointCount = 0;
}
static void breakManyJoints( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->jointCount = 1000000;
}
static void breakParentsNull( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->parents = NULL;
}
static void breakBindNull( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->bindPose = NULL;
}
static void breakParentRange( soleRigDef* def, testBiped* biped )
{
	(void)def;
	biped->parents[3] = 77;
}
static void breakCycle( soleRigDef* def, testBiped* biped )
{
	(void)def;
	biped->parents[biped_pelvis] = biped_kneeL;
}
static void breakBindNan( soleRigDef* def, testBiped* biped )
{
	(void)def;
	biped->bindPose[4].translation.x = NAN;
}
static void breakPelvis( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->pelvis = -5;
}
static void breakPelvisElsewhere( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->pelvis = biped_spine;
}
static void breakNoLegs( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legCount = 0;
}
static void breakManyLegs( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legCount = 17;
}
static void breakUp( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->up = def->forward;
}
static void breakLegJointCount( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[1].jointCount = 1;
}
static void breakLegJoint( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[1].joints[2] = 99;
}
static void breakLegOrder( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].joints[1] = biped_ankleL;
	def->legs[0].joints[2] = biped_kneeL;
}
static void breakDetached( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].detachedFoot = biped_ankleL;
}
static void breakToeCount( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].toeCount = 9;
}
static void breakToe( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].toes[0] = biped_toeR;
}
static void breakSole( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].sole.heel.y = INFINITY;
}
static void breakLimits( soleRigDef* def, testBiped* biped )
{
	(void)biped;
	def->legs[0].ankleLimits.twist = -1.0f;
}
static void breakLengthInfinite( soleRigDef* def, testBiped* biped )
{
	(void)def;
	biped->bindPose[biped_kneeL].translation.y = -1e25f;
}
static void breakLength( soleRigDef* def, testBiped* biped )
{
	(void)def;
	for ( int j = biped_kneeL; j <= biped_ankleL; ++j )
	{
		biped->bindPose[j].translation = soleVec( 0.0f, 0.0f, 0.0f );
	}
}
static void breakHinge( soleRigDef* def, testBiped* biped )
{
	def->legs[0].hinge = soleVec( 0.0f, 0.0f, 0.0f );
	testBendKnees( biped->bindPose, 0.0f );
}

static void everyBadDefinitionIsRefusedByName( void** state )
{
	(void)state;
	static const struct
	{
		breakFcn* apply;
		const char* field;
	} cases[] = { { breakCookie, "definition" }, { breakJointCount, "jointCount" }, { breakManyJoints, "jointCount" },
		{ breakParentsNull, "parents" }, { breakBindNull, "bindPose" }, { breakParentRange, "parents[3]" },
		{ breakCycle, "parents[" }, { breakBindNan, "bindPose[4]" }, { breakPelvis, "pelvis" },
		{ breakPelvisElsewhere, "pelvis" }, { breakNoLegs, "legCount" }, { breakManyLegs, "legCount" },
		{ breakUp, "up" }, { breakLegJointCount, "legs[1].jointCount" }, { breakLegJoint, "legs[1].joints[2]" },
		{ breakLegOrder, "legs[0].joints[" }, { breakDetached, "legs[0].detachedFoot" },
		{ breakToeCount, "legs[0].toeCount" }, { breakToe, "legs[0].toes[0]" }, { breakSole, "legs[0].sole.heel" },
		{ breakLimits, "legs[0].ankleLimits" }, { breakLength, "legs[0]" }, { breakLengthInfinite, "too long" },
		{ breakHinge, "legs[0].hinge" } };
	for ( size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i )
	{
		testBiped biped;
		soleRigDef def = testBipedDef( &biped );
		cases[i].apply( &def, &biped );
		soleMessage message;
		soleRig* rig = (soleRig*)&message;
		assert_int_equal( soleCreateRig( &def, NULL, &rig, &message ), sole_invalidDefinition );
		assert_null( rig );
		if ( strstr( message.text, cases[i].field ) == NULL )
		{
			print_error( "case %zu: '%s' does not name %s\n", i, message.text, cases[i].field );
			fail();
		}
		assert_non_null( strchr( message.text, ':' ) ); // and says how to mend it
		assert_int_equal( soleCreateRig( &def, NULL, &rig, NULL ), sole_invalidDefinition );
	}
}

static void zeroHingeIsTakenFromTheBend( void** state )
{
	(void)state;
	testBiped biped;
	soleRigDef def = testBipedDef( &biped );
	def.legs[0].hinge = soleVec( 0.0f, 0.0f, 0.0f );
	soleRig* rig;
	assert_int_equal( soleCreateRig( &def, NULL, &rig, NULL ), sole_success );
	testNear3( soleRig_GetLeg( rig, 0 ).hinge, soleVec( 1.0f, 0.0f, 0.0f ), 1e-5f );
	soleDestroyRig( rig );
}

static void rigTellsWhatItWasMadeOf( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	assert_int_equal( soleRig_GetJointCount( biped.rig ), biped_count );
	assert_int_equal( soleRig_GetLegCount( biped.rig ), 2 );
	assert_int_equal( soleRig_GetPelvis( biped.rig ), biped_pelvis );
	assert_float_equal( soleRig_GetLegLength( biped.rig, 0 ), 0.9f, 1e-5f );
	assert_string_equal( soleRig_GetLeg( biped.rig, 1 ).name, "right" );
	assert_int_equal( soleRig_GetFootJoint( biped.rig, 0, false ), biped_ankleL );
	assert_int_equal( soleRig_GetFootJoint( biped.rig, 0, true ), biped_toeL );
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		assert_int_equal( soleRig_GetParent( biped.rig, j ), biped.parents[j] );
	}
	soleVec3 heel = soleRig_GetLeg( biped.rig, 0 ).sole.heel;
	soleVec3 local = soleRig_ToFootSpace( biped.rig, 0, heel, false );
	soleTransform foot = testJoint( &biped, biped.bindPose, soleTransform_Identity(), biped_ankleL );
	testNear3( soleTransformPoint( foot, local ), heel, 1e-6f );
	soleDestroyRig( biped.rig );
}

typedef struct Meter
{
	size_t out;
	int left; // allocations before the next one fails
} Meter;

static void* meteredAlloc( size_t byteCount, void* user )
{
	Meter* meter = user;
	if ( meter->left-- <= 0 )
	{
		return NULL;
	}
	meter->out += byteCount;
	return malloc( byteCount );
}

static void meteredFree( void* memory, size_t byteCount, void* user )
{
	Meter* meter = user;
	meter->out -= byteCount;
	free( memory );
}

static void memoryIsGivenBackWhateverHappens( void** state )
{
	(void)state;
	testBiped biped;
	soleRigDef def = testBipedDef( &biped );
	Meter meter = { 0, 0 };
	soleAllocator allocator = { meteredAlloc, meteredFree, &meter };
	soleRig* rig;
	soleMessage message;
	assert_int_equal( soleCreateRig( &def, &allocator, &rig, &message ), sole_outOfMemory );
	assert_null( rig );
	meter.left = 100;
	assert_int_equal( soleCreateRig( &def, &allocator, &rig, &message ), sole_success );
	assert_true( meter.out > 0 );
	soleDestroyRig( rig );
	assert_int_equal( meter.out, 0 );
	breakHinge( &def, &biped );
	assert_int_equal( soleCreateRig( &def, &allocator, &rig, &message ), sole_invalidDefinition );
	assert_int_equal( meter.out, 0 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyBadDefinitionIsRefusedByName ),
		cmocka_unit_test( zeroHingeIsTakenFromTheBend ),
		cmocka_unit_test( rigTellsWhatItWasMadeOf ),
		cmocka_unit_test( memoryIsGivenBackWhateverHappens ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
