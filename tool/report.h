// SPDX-License-Identifier: MIT
// What a report tells, as JSON: who walked where, the curves of every take, figures beside their targets, settings.
#ifndef TOOL_REPORT_H
#define TOOL_REPORT_H

#include "bake_job.h"

struct json_object;

/// { "version", "character", "ground", "legLength", "legs": [ { "name", "joints" } ], "walks": [], "settings": [ {
/// "name", "unit", "value", "default", "text" } ] }: settings that differ from their defaults; walks are to be added.
struct json_object* toolBeginReport( const toolBakeJob* job );

/// Adds the walk of a clip to a report, { "clip", "fps", "frames", "skip", "speed", "labels", "takes", "rows" }: per
/// leg and frame a soleContactLabel of the clip; takes as { "method", "summary", "clip", "figures", "legs": [ {
/// "height", "bend", "acceleration", "planted" } ], "pelvis" }, numbers a frame in SI units, null where there is none;
/// rows as { "name", "title", "unit", "decimals", "atLeast", "cells": [ { "value", "limit", "holds" } ] }, a cell a
/// take.
bool toolAddWalk( const toolBakeJob* job, const toolBakedClip* baked, struct json_object* report, toolError* error );

#endif
