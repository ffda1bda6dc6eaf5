// SPDX-License-Identifier: MIT
// The table of settings: the one place of their names, units, ranges and defaults. Files, viewers and documents read
// it.
#include "rig/settings.h"

#include <string.h>

// A build that has to be small, and shows the sentences from elsewhere or not at all, leaves them out.
#ifndef SOLE_SETTING_TEXTS
#define SOLE_SETTING_TEXTS 1
#endif
#if SOLE_SETTING_TEXTS
#define SENTENCE( text ) text
#else
#define SENTENCE( text ) ""
#endif

#define FLOAT( field, unit, low, high, value, text )                                                                   \
	{                                                                                                                  \
#field, unit, sole_settingFloat, offsetof( soleSettings, field ), low, high, value, SENTENCE( text )           \
	}
#define ENUM( field, high, value, text )                                                                               \
	{                                                                                                                  \
#field, "", sole_settingEnum, offsetof( soleSettings, field ), 0, high, value, SENTENCE( text )                \
	}
#define MASK( field, text )                                                                                            \
	{                                                                                                                  \
#field, "", sole_settingMask, offsetof( soleSettings, field ), 0, 4294967295.0, 4294967295.0, SENTENCE( text ) \
	}

static const soleSettingInfo soleSettingInfos[] = {
	ENUM( probe.shape, 1, 0, "What is cast at the ground: 0 a ray, 1 a sphere." ),
	ENUM( probe.layout, 2, 0, "Probes a foot: 0 economy (5), 1 quality (18), 2 single (1)." ),
	FLOAT( probe.radius, "L", 0.001, 0.3, 0.05, "Radius of spheres." ),
	FLOAT( probe.stepUp, "L", 0.05, 2, 0.45, "Ground this far above the root is still found." ),
	FLOAT( probe.stepDown, "L", 0.05, 4, 0.55, "Ground this far below the root is still found." ),
	FLOAT( probe.looseSize, "L", 0, 2, 0.1, "Loose things smaller than this are no ground." ),
	FLOAT( probe.sleep, "s", 0, 60, 0, "A foot that has stood still for so long asks one probe alone. 0: none does." ),
	MASK( probe.mask, "Layers that count as ground." ),
	ENUM( support.filter, 1, 0, "Heights are smoothed 0 by time, 1 by call, asked every 0.02 s: set at the start." ),
	FLOAT( support.maxSlope, "rad", 0, 1.5, 0.8726646, "Steeper ground gives height but does not tilt the foot." ),
	FLOAT(
	    support.levelGap, "L", 0, 0.5, 0.022, "Neighbouring probes this far beyond 45 degrees are on other levels." ),
	FLOAT( support.loadPoint, "", 0, 1, 0.5, "Where the sole bears, from heel to toe tip." ),
	FLOAT( support.lookAhead, "s", 0, 0.5, 0.08,
	    "A foot in flight rises for what its toes will pass over within this time." ),
	FLOAT( support.heightHalfLife, "s", 0, 1, 0.045, "How fast a foot in flight takes up a step of the ground." ),
	FLOAT( support.gradientHalfLife, "s", 0, 1, 0.05, "How fast a foot in flight takes up a change of slope." ),
	FLOAT( support.plantedHalfLife, "s", 0, 1, 0.02, "How fast a planted foot takes up what is left of both." ),
	FLOAT( support.toeHalfLife, "s", 0, 1, 0.04, "How fast the toes take up a change of the ground before them." ),
	FLOAT( contact.speedOn, "L/s", 0, 20, 0.25, "A sole point slower than this may plant." ),
	FLOAT( contact.speedOff, "L/s", 0, 40, 0.6, "A sole point faster than this releases." ),
	FLOAT( contact.heightOn, "L", 0, 1, 0.025, "A sole point lower than this over the clip's floor may plant." ),
	FLOAT( contact.heightOff, "L", 0, 1, 0.05, "A sole point higher than this releases." ),
	FLOAT( contact.settle, "s", 0, 1, 0.033, "A foot that looks planted for this long is planted." ),
	ENUM( contact.pivot, 2, 0, "What a held foot turns about: 0 nothing, 1 its ball, 2 its ankle." ),
	FLOAT( contact.lockDistance, "L", 0, 2, 0.25,
	    "A lock that has gone this far from the animation is given up. 0: none." ),
	FLOAT( contact.lockAngle, "rad", 0, 3, 0.7853982, "A lock turned further than this is given up." ),
	FLOAT( contact.relock, "", 0, 1, 0.4, "Share of both within which a lock that was given up may begin anew." ),
	FLOAT( contact.replantDistance, "L", 0, 2, 0.1, "A foot at rest that is further off than this steps over." ),
	FLOAT(
	    contact.replantAngle, "rad", 0, 3, 0.3490659, "A foot at rest that is turned further than this steps over." ),
	FLOAT( contact.replantAfter, "s", 0, 60, 0.8, "If it has been so for this long." ),
	FLOAT( contact.replantTime, "s", 0.02, 2, 0.25, "How long such a step takes." ),
	FLOAT( contact.captureHalfLife, "s", 0, 1, 0.05, "How fast a foot comes to rest when it is locked." ),
	FLOAT( contact.releaseHalfLife, "s", 0, 1, 0.08, "How fast a foot returns to the animation when it is let go." ),
	FLOAT( contact.fadeIn, "s", 0, 1, 0.12, "Time in which a planted leg gets its full say in the pelvis." ),
	FLOAT( contact.fadeOut, "s", 0, 1, 0.2, "Time in which a released leg loses its say in the pelvis." ),
	FLOAT( foothold.shift, "L", 0, 0.5, 0.2, "Furthest that a step is shifted along the foot to stand better." ),
	FLOAT( foothold.share, "", 0, 1, 0.9, "A sole that bears with this share of its length stands well." ),
	FLOAT( foothold.freeze, "s", 0, 1, 0.085, "The place of a step is settled this long before the foot comes down." ),
	FLOAT( target.align, "", 0, 1, 1, "Share of the ground's slope that the foot follows." ),
	FLOAT( target.maxTilt, "rad", 0, 1.5, 1.5, "Furthest that the ground tilts a foot." ),
	FLOAT( target.flatten, "rad", 0, 0.5, 0.1,
	    "A heel that is down, but off the clip's floor, is put down by a turn of at most this." ),
	FLOAT( target.height, "L", -0.5, 0.5, 0, "Soles are kept this far over the ground." ),
	FLOAT( target.flight, "", 0, 1, 1, "Share of the placement that a foot in flight keeps." ),
	FLOAT( target.moving, "", 0, 1, 1, "Share of the placement that is left while the root moves." ),
	FLOAT( target.unreachable, "", 0, 1, 1,
	    "Share that is left to a foot whose ground is too low, too high or too steep." ),
	FLOAT( target.toeOutLeft, "rad", -1.5, 1.5, 0, "A left foot is turned outwards by this." ),
	FLOAT( target.toeOutRight, "rad", -1.5, 1.5, 0, "A right foot is turned outwards by this." ),
	FLOAT( target.blendIn, "s", 0, 10, 0.2, "Time in which a weight rises from 0 to 1." ),
	FLOAT( target.blendOut, "s", 0, 10, 0.15, "Time in which a weight falls from 1 to 0." ),
	FLOAT( target.secondFrom, "L", 0, 2, 0.25, "The second pose begins at this difference of heights." ),
	FLOAT( target.secondFull, "L", 0, 2, 0.55, "The second pose is full at this difference of heights." ),
	FLOAT( target.secondTime, "s", 0, 2, 0.12, "How fast the second pose comes and goes." ),
	FLOAT( activity.slow, "L/s", 0, 40, 2.5, "Up to this speed of the root the placement is whole." ),
	FLOAT( activity.fast, "L/s", 0, 40, 4.5, "From this speed of the root on the character runs." ),
	FLOAT( activity.running, "", 0, 1, 1, "Share of the placement that is left while it runs." ),
	FLOAT( activity.low, "L", 0, 2, 0.2, "Up to this height of all soles over their ground the placement is whole." ),
	FLOAT( activity.high, "L", 0, 2, 0.4, "From this height of all soles on the character is in the air." ),
	FLOAT( activity.airborne, "", 0, 1, 1, "Share of the placement that is left in the air." ),
	FLOAT( layer.knee, "", 0, 1, 0, "A foot on its way up a high step is lifted further by this share of its rise." ),
	FLOAT( layer.hips, "L", 0, 0.3, 0, "The hips go away from a much higher foot by this on a slope of 45 degrees." ),
	FLOAT( layer.lean, "", 0, 1, 0, "The trunk leans towards a much higher foot by this share of the slope." ),
	ENUM( pelvis.follow, 2, 0, "Which feet the pelvis goes with: 0 all steps, 1 planted feet, 2 the lowest foot." ),
	ENUM( pelvis.mode, 2, 0, "Who moves the pelvis: 0 its joint, 1 the host with the root, 2 nobody." ),
	FLOAT( pelvis.down, "L", 0, 1, 0.45, "Furthest that the pelvis goes down." ),
	FLOAT( pelvis.up, "L", 0, 1, 0.1, "Furthest that the pelvis goes up." ),
	FLOAT( pelvis.halfLife, "s", 0, 2, 0.08, "How fast the pelvis follows the legs." ),
	FLOAT( pelvis.hold, "s", 0, 4, 1.2, "The pelvis stays down for so long after it had to, for the next step." ),
	FLOAT( pelvis.release, "s", 0, 4, 0.2, "Half-life of its way up from there." ),
	FLOAT( pelvis.speed, "L/s", 0, 100, 0.9, "Fastest that the pelvis moves up or down beyond the animation." ),
	FLOAT( pelvis.balance, "", 0, 1, 0, "Share of the feet's mean shift that the pelvis follows sideways." ),
	FLOAT( pelvis.sideways, "L", 0, 1, 0.1, "Furthest that the pelvis moves sideways." ),
	FLOAT( pelvis.heelFirst, "", 0, 1, 0.5, "Share of the heel lift that is used up before the pelvis goes down." ),
	FLOAT( leg.reach, "", 0.5, 1, 0.995, "Furthest extension of a leg as a share of its bones." ),
	FLOAT( leg.softZone, "L", 0, 0.3, 0.02, "The reach limit is approached softly over this much." ),
	FLOAT( leg.fold, "", 0, 0.9, 0.26, "Least extension of a leg as a share of its bones." ),
	FLOAT( leg.stretch, "", 0, 0.05, 0, "Most that the bones are made longer to reach." ),
	FLOAT( leg.twist, "", 0, 1, 0, "Share of a foot's turn about the leg that the thigh takes." ),
	FLOAT( leg.heelLift, "rad", 0, 1.4, 0.8726646, "Most that a heel is raised to reach the ground." ),
	FLOAT( ankle.toeUp, "rad", 0, 1.5, 1.1344640, "Furthest that the toes bend up." ),
	FLOAT( ankle.toeDown, "rad", 0, 1.5, 0.2617994, "Furthest that the toes bend down." ),
};

const soleSettingInfo* soleGetSettingInfos( int32_t* count )
{
	if ( count != NULL )
	{
		*count = (int32_t)( sizeof soleSettingInfos / sizeof soleSettingInfos[0] );
	}
	return soleSettingInfos;
}

double soleSettings_Get( const soleSettings* settings, const soleSettingInfo* info )
{
	const char* field = (const char*)settings + info->offset;
	if ( info->type == sole_settingFloat )
	{
		float value;
		memcpy( &value, field, sizeof value );
		return (double)value;
	}
	if ( info->type == sole_settingEnum )
	{
		int32_t value;
		memcpy( &value, field, sizeof value );
		return (double)value;
	}
	uint32_t value;
	memcpy( &value, field, sizeof value );
	return (double)value;
}

void soleSettings_Set( soleSettings* settings, const soleSettingInfo* info, double value )
{
	if ( !( value - value == 0.0 ) )
	{
		return;
	}
	value = value < info->minimum ? info->minimum : ( value > info->maximum ? info->maximum : value );
	char* field = (char*)settings + info->offset;
	if ( info->type == sole_settingFloat )
	{
		float number = (float)value;
		memcpy( field, &number, sizeof number );
	}
	else if ( info->type == sole_settingEnum )
	{
		int32_t number = (int32_t)value;
		memcpy( field, &number, sizeof number );
	}
	else
	{
		uint32_t number = (uint32_t)value;
		memcpy( field, &number, sizeof number );
	}
}

/// A word as an integer: floats in their order, minus zero right under zero, what is no number outside of all of them.
/// An integer below zero stays below zero, which is all that is asked: an enumerator may not be, a mask may be
/// anything.
static inline int32_t soleOrderWord( uint32_t bits )
{
	uint32_t magnitude = ( 0u - ( bits >> 31 ) ) >> 1; // all bits but the highest where that is set
	uint32_t ordered = bits ^ magnitude;
	int32_t word;
	memcpy( &word, &ordered, sizeof word );
	return word;
}

static int32_t soleOrderFloat( float value )
{
	uint32_t bits;
	memcpy( &bits, &value, sizeof bits );
	return soleOrderWord( bits );
}

void soleFillSettingRanges( soleSettingRanges* ranges )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		size_t word = infos[i].offset / sizeof( float );
		bool isFloat = infos[i].type == sole_settingFloat;
		bool isMask = infos[i].type == sole_settingMask;
		// Zero has two signs.
		float low = infos[i].minimum == 0.0 ? -0.0f : (float)infos[i].minimum;
		ranges->low[word] = isFloat ? soleOrderFloat( low ) : ( isMask ? INT32_MIN : 0 );
		ranges->high[word] =
		    isFloat ? soleOrderFloat( (float)infos[i].maximum ) : ( isMask ? INT32_MAX : (int32_t)infos[i].maximum );
	}
}

bool soleSettings_AreInRange( const soleSettings* settings, const soleSettingRanges* ranges )
{
	// Without branches: compilers make wide code of it.
	uint32_t out = 0;
	for ( size_t i = 0; i < SOLE_SETTING_WORDS; ++i )
	{
		uint32_t bits;
		memcpy( &bits, (const char*)settings + i * sizeof bits, sizeof bits );
		int32_t word = soleOrderWord( bits );
		out |= (uint32_t)( word < ranges->low[i] ) | (uint32_t)( word > ranges->high[i] );
	}
	return out == 0;
}

soleSettings soleDefaultSettings( void )
{
	soleSettings settings = { 0 };
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleSettings_Set( &settings, infos + i, infos[i].defaultValue );
	}
	settings.internalValue = SOLE_COOKIE;
	return settings;
}
