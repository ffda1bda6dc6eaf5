// SPDX-License-Identifier: MIT
// What a host tells of its clips: contacts and steps.
#ifndef TEST_SCENE_STEPS_H
#define TEST_SCENE_STEPS_H

#include "scene_run.h"

/// Contacts and steps of all legs in a frame of a run, by what was found in the clip beforehand, and by how the root
/// has moved until then.
/// @return false: the host of this act knows nothing of them
bool testReadSteps( const testRun* run, int32_t frame, soleContactInput* contacts, soleStepInput* inputs );

#endif
