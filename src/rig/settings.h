// SPDX-License-Identifier: MIT
// The ranges of settings, laid out as the settings are: so that a frame can tell at little cost that all of them are
// within. A rig keeps them: the library has no memory of its own.
#ifndef SOLE_RIG_SETTINGS_H
#define SOLE_RIG_SETTINGS_H

#include "sole/sole.h"

#define SOLE_SETTING_WORDS ( offsetof( soleSettings, internalValue ) / sizeof( float ) )

/// Per word of the settings. A float has any integer for a range, and an integer any float.
typedef struct soleSettingRanges
{
	uint32_t isFloat[SOLE_SETTING_WORDS]; // all bits or none
	float low[SOLE_SETTING_WORDS];
	float high[SOLE_SETTING_WORDS];
	int32_t lowInteger[SOLE_SETTING_WORDS];
	int32_t highInteger[SOLE_SETTING_WORDS];
} soleSettingRanges;

void soleFillSettingRanges( soleSettingRanges* ranges );

/// All of them are numbers in their ranges.
bool soleSettings_AreInRange( const soleSettings* settings, const soleSettingRanges* ranges );

#endif
