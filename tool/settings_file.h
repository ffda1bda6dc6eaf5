// SPDX-License-Identifier: MIT
// Settings as JSON: { "probe": { "radius": 0.05 }, ... }, one name per field, the same as in soleSettings.
#ifndef TOOL_SETTINGS_FILE_H
#define TOOL_SETTINGS_FILE_H

#include "sole/sole.h"
#include "tool.h"

/// Changes the settings that the file names; what it does not name stays. Refused as a whole: a name that is no
/// setting, a value of another type or out of its range.
bool toolReadSettings( const char* path, soleSettings* settings, toolError* error );
bool toolParseSettings(
    const char* text, size_t byteCount, const char* path, soleSettings* settings, toolError* error );

/// All settings as JSON text, in the order of the struct.
char* toolFormatSettings( const soleSettings* settings );

#endif
