// SPDX-License-Identifier: MIT
// The settings of the four systems under the names of the originals, as tables: for an inspector that shows and changes
// them. The rows are those of Sole's own table, soleSettingInfo; offsets count from the start of a soleAncestor. A
// float is a float, an enum a switch (bool), a mask layers (uint32_t).
#ifndef SOLE_BASELINES_ANCESTOR_TABLE_H
#define SOLE_BASELINES_ANCESTOR_TABLE_H

#include "baselines/ancestor.h"

/// The table of one system: names are "homebrew.smoothTime". Defaults are those before a character is fitted, ranges
/// the originals' where they have some, and else what is of use; a fitted value may lie outside.
const soleSettingInfo* soleGetAncestorSettingInfos( soleAncestorKind kind, int32_t* count );

double soleAncestor_GetSetting( const soleAncestor* ancestor, const soleSettingInfo* info );
/// What is no finite number changes nothing. Ranges are not kept to: they are those of an average human.
void soleAncestor_SetSetting( soleAncestor* ancestor, const soleSettingInfo* info, double value );

#endif
