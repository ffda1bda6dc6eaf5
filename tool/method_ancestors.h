// SPDX-License-Identifier: MIT
// The systems that Sole is compared with, as methods of a bake.
#ifndef TOOL_METHOD_ANCESTORS_H
#define TOOL_METHOD_ANCESTORS_H

#include "bake.h"

void* toolStartHomebrew( const toolCharacter* character );
void* toolStartIkSetting( const toolCharacter* character );
void* toolStartOzz( const toolCharacter* character );
void* toolStartEffector( const toolCharacter* character );
void toolStepAncestor( void* user, const toolMethodStep* step );

#endif
