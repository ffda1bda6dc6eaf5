// SPDX-License-Identifier: MIT
// The mannequin: a skinned figure of a grown person with clips to walk, run, turn and stand, made by formulas alone.
#ifndef TOOL_MANNEQUIN_H
#define TOOL_MANNEQUIN_H

#include "model.h"

/// Fills a model: 1.75 m tall, y up, faces +z, left at +x, in metres. Free it with toolFreeModel().
///
/// The node `root` carries the travel, `hips` hangs below it, the mesh is a root node of its own. Clips, all LINEAR:
///   idle       4 s, looped, both feet stand still
///   walk       in place, looped; the stance feet pretend 1.3 m/s
///   run        in place, looped; the stance feet pretend 3.3 m/s
///   turn       90 degrees to the left on the spot, by the root's rotation; the pose is looped, the root is not
///   walk_root  the walk with its travel in the root
///   strafe     sidesteps to the left, in place, looped; the stance feet pretend 0.3 m/s
///   crouch     4 s, looped, both feet stand still, the hips 0.35 lower than in idle
///   crouch_walk  in place, looped, hips low; the stance feet pretend 0.8 m/s
void toolMakeMannequin( toolModel* model );

#endif
