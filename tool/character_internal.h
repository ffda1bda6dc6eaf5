// SPDX-License-Identifier: MIT
// What the files that make a character share.
#ifndef TOOL_CHARACTER_INTERNAL_H
#define TOOL_CHARACTER_INTERNAL_H

#include "motion.h"

/// Fills in bindPose (allocated, jointCount) from the skins' inverse bind matrices, else the rest pose.
void toolFindBindPose( toolCharacter* character );

/// Fills in skin and skinCount: all vertices that move with joints, character space, bind pose.
void toolCollectSkin( toolCharacter* character );

/// Fills in points and pointCount. The rig is there already.
void toolCollectPoints( toolCharacter* character );

#endif
