// SPDX-License-Identifier: MIT
// The tables of the ancestors' settings: one row a field of their settings structs, with the original's name.
#include "baselines/ancestor_table.h"

#include <string.h>

#define ROW( name, field, unit, type, low, high, value, text )                                                         \
	{                                                                                                                  \
		name, unit, type, offsetof( soleAncestor, settings.field ), low, high, value, text                             \
	}
#define HOMEBREW( field, unit, low, high, value, text )                                                                \
	ROW( "homebrew." #field, homebrew.field, unit, sole_settingFloat, low, high, value, text )
#define HOMEBREW_SWITCH( field, value, text )                                                                          \
	ROW( "homebrew." #field, homebrew.field, "", sole_settingEnum, 0, 1, value, text )
#define IK( field, unit, low, high, value, text )                                                                      \
	ROW( "iksetting." #field, ikSetting.field, unit, sole_settingFloat, low, high, value, text )
#define IK_SWITCH( field, value, text )                                                                                \
	ROW( "iksetting." #field, ikSetting.field, "", sole_settingEnum, 0, 1, value, text )
#define EFFECTOR( field, unit, low, high, value, text )                                                                \
	ROW( "effector." #field, effector.field, unit, sole_settingFloat, low, high, value, text )
#define OZZ( field, unit, low, high, value, text )                                                                     \
	ROW( "ozz." #field, ozz.field, unit, sole_settingFloat, low, high, value, text )
#define OZZ_SWITCH( field, value, text ) ROW( "ozz." #field, ozz.field, "", sole_settingEnum, 0, 1, value, text )
#define ALL_LAYERS 4294967295.0

static const soleSettingInfo soleHomebrewInfos[] = {
	HOMEBREW( globalWeight, "", 0, 1, 1, "Share of all that is done." ),
	HOMEBREW( leftFootWeight, "", 0, 1, 1, "Share of what is done to left feet, and to those in the middle." ),
	HOMEBREW( rightFootWeight, "", 0, 1, 1, "Share of what is done to right feet." ),
	ROW( "homebrew.groundLayers", homebrew.groundLayers, "", sole_settingMask, 0, ALL_LAYERS, 0,
	    "Layers that are ground. None chosen counts as the lowest." ),
	HOMEBREW( smoothTime, "s", 0, 1, 0.08, "How slowly the springs of a foot's height and normal follow." ),
	HOMEBREW( raySphereRadius, "m", 0, 1, 0.05, "Radius of the sphere that is cast under a foot." ),
	HOMEBREW( ankleHeightOffset, "m", -1, 1, 0.03, "Height of the ankle over the sole, beyond the sphere's radius." ),
	HOMEBREW( lengthFromHeelToToes, "m", 0, 1, 0.19,
	    "Length of the foot: a tilted one is raised so that neither end sinks." ),
	HOMEBREW( maxRotationAngle, "deg", 0, 90, 45, "Furthest that the ground tilts a foot." ),
	HOMEBREW( rayCastRange, "m", 0, 10, 1.2, "How far down the sphere is cast." ),
	HOMEBREW( leftFootRaycastStartHeight, "m", 0, 5, 0.5, "How high over a left ankle the cast starts." ),
	HOMEBREW( rightFootRaycastStartHeight, "m", 0, 5, 0.5, "How high over a right ankle the cast starts." ),
	HOMEBREW( floorRange, "m", 0, 1, 0.1, "A foot that is animated no higher than this is on the floor." ),
	HOMEBREW( crouchRange, "m", 0, 1, 0.25, "Most that the legs bend for before the body is lifted." ),
	HOMEBREW( stretchRange, "m", 0, 1, 0, "Most that the body stays above what the lower foot asks." ),
	HOMEBREW( worldHeightOffset, "m", -1, 1, 0, "Added to the height of both feet, where it is enabled." ),
	HOMEBREW_SWITCH( enableFootRotation, 1, "Feet turn with the ground." ),
	HOMEBREW_SWITCH( enableFootLifting, 1, "A foot that is animated higher than its place is let go." ),
	HOMEBREW_SWITCH( enableBodyPositioning, 1, "The body follows the lower foot." ),
	HOMEBREW_SWITCH( enableWorldHeightOffset, 0, "The world's height offset counts." ),
};

static const soleSettingInfo soleIkSettingInfos[] = {
	IK_SWITCH( enableFeetIk, 1, "Feet are placed at all." ),
	IK( heightFromGroundRaycast, "m", 0, 2, 1.2, "How high over the root the rays start." ),
	IK( raycastDownDistance, "m", 0, 2, 1.5, "How far below the root the rays go." ),
	ROW( "iksetting.environmentLayer", ikSetting.environmentLayer, "", sole_settingMask, 0, ALL_LAYERS, ALL_LAYERS,
	    "Layers that are ground." ),
	IK( pelvisOffset, "m", -1, 1, 0, "Added to the height of the ground under each foot." ),
	IK( pelvisUpAndDownSpeed, "", 0, 1, 0.28, "Share of its way that the body goes in a frame." ),
	IK( feetToIkPositionSpeed, "", 0, 1, 0.5, "Share of its way that a foot goes in a frame." ),
	IK( leftFootAngleOffset, "deg", 0, 100, 0, "A left foot is turned about up by this." ),
	IK( rightFootAngleOffset, "deg", 0, 100, 0, "A right foot is turned about up by this." ),
	IK_SWITCH( useIkFeature, 0, "Feet turn with the ground as well." ),
};

static const soleSettingInfo soleEffectorInfos[] = {
	ROW( "effector.enableAnimationIk", effector.enableAnimationIk, "", sole_settingEnum, 0, 1, 1,
	    "Feet are placed at all." ),
	EFFECTOR( meshScale, "", 0.1, 4, 1, "Scale of the mesh along up, in the capsule." ),
	EFFECTOR( transformScale, "", 0.1, 4, 1, "Scale of the character along up." ),
	EFFECTOR(
	    capsuleHalfHeight, "cm", 1, 200, 88, "Half of the capsule's height at rest: traces start at its middle." ),
	EFFECTOR( traceDistance, "cm", 0, 200, 55, "How far below the capsule is traced." ),
	EFFECTOR( footAdjustment, "cm", -20, 20, 0, "Added to the height of each ground that is met." ),
	EFFECTOR( feetInterpSpeed, "1/s", 0, 60, 15, "How fast the feet follow. 0: at once." ),
	EFFECTOR( hipInterpSpeed, "1/s", 0, 60, 10, "How fast hip and capsule follow. 0: at once." ),
	EFFECTOR( nearlyEqual, "cm", 0, 10, 1, "A foot so near to where it goes is there." ),
	EFFECTOR( unitsPerCentimetre, "m", 0.001, 1, 0.01, "The world's unit: so much of it is a centimetre." ),
};

static const soleSettingInfo soleOzzInfos[] = {
	OZZ_SWITCH( autoCharacterHeight, 1, "The whole character is put on the ground under its root." ),
	OZZ_SWITCH( pelvisCorrection, 1, "The pelvis goes down so that the lowest ankle reaches." ),
	OZZ_SWITCH( twoBoneIk, 1, "Legs bend so that ankles reach their targets." ),
	OZZ_SWITCH( aimIk, 1, "Feet turn with the ground." ),
	OZZ( footHeight, "m", 0, 0.3, 0.12, "Height of the ankle over the ground." ),
	OZZ( weight, "", 0, 1, 1, "Share of both kinds of IK." ),
	OZZ( soften, "", 0, 1, 1, "A leg longer than this share of its bones gives in." ),
	OZZ( rootRayHeight, "m", 0, 20, 10, "How high over the root its ray starts." ),
	OZZ( ankleRayHeight, "m", 0, 2, 0.5, "How high over the ankles their rays start." ),
	OZZ( aimHeight, "m", 0.1, 4, 1, "What an ankle's up points at is so far off its target." ),
	ROW( "ozz.floorMask", ozz.floorMask, "", sole_settingMask, 0, ALL_LAYERS, ALL_LAYERS, "Layers that are floor." ),
};

#define TABLE( infos ) ( *count = (int32_t)( sizeof( infos ) / sizeof( infos )[0] ), ( infos ) )

const soleSettingInfo* soleGetAncestorSettingInfos( soleAncestorKind kind, int32_t* count )
{
	switch ( kind )
	{
	case sole_ancestorHomebrew:
		return TABLE( soleHomebrewInfos );
	case sole_ancestorIkSetting:
		return TABLE( soleIkSettingInfos );
	case sole_ancestorEffector:
		return TABLE( soleEffectorInfos );
	default:
		return TABLE( soleOzzInfos );
	}
}

double soleAncestor_GetSetting( const soleAncestor* ancestor, const soleSettingInfo* info )
{
	const char* field = (const char*)ancestor + info->offset;
	if ( info->type == sole_settingEnum )
	{
		bool on;
		memcpy( &on, field, sizeof on );
		return on ? 1.0 : 0.0;
	}
	if ( info->type == sole_settingMask )
	{
		uint32_t layers;
		memcpy( &layers, field, sizeof layers );
		return (double)layers;
	}
	float number;
	memcpy( &number, field, sizeof number );
	return (double)number;
}

void soleAncestor_SetSetting( soleAncestor* ancestor, const soleSettingInfo* info, double value )
{
	if ( !( value - value == 0.0 ) )
	{
		return;
	}
	char* field = (char*)ancestor + info->offset;
	if ( info->type == sole_settingEnum )
	{
		bool on = value != 0.0;
		memcpy( field, &on, sizeof on );
	}
	else if ( info->type == sole_settingMask )
	{
		uint32_t layers = value <= 0.0 ? 0u : ( value >= ALL_LAYERS ? UINT32_MAX : (uint32_t)value );
		memcpy( field, &layers, sizeof layers );
	}
	else
	{
		float number = (float)value;
		memcpy( field, &number, sizeof number );
	}
}
