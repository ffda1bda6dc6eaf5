// SPDX-License-Identifier: MIT
// The ranges of settings, laid out as the settings are: so that a frame can tell at little cost that all of them are
// within. A rig keeps them: the library has no memory of its own.
#ifndef SOLE_RIG_SETTINGS_H
#define SOLE_RIG_SETTINGS_H

#include "sole/sole.h"

#define SOLE_SETTING_WORDS ( offsetof( soleSettings, internalValue ) / sizeof( float ) )

/// Per word of the settings, what is in range as an integer that is in order: of a float its bits as sign and magnitude
/// turned into two's complement, of an integer itself.
typedef struct soleSettingRanges
{
	int32_t low[SOLE_SETTING_WORDS];
	int32_t high[SOLE_SETTING_WORDS];
} soleSettingRanges;

void soleFillSettingRanges( soleSettingRanges* ranges );

/// All of them are numbers in their ranges.
bool soleSettings_AreInRange( const soleSettings* settings, const soleSettingRanges* ranges );

#endif
