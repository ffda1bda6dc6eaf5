// SPDX-License-Identifier: MIT
// The acts of all scenes: a table. Lengths in metres, angles in degrees, times in seconds.
#include "act_play.h"

// A stride of two steps on stairs is two treads, or four; without one it is the clip's own.
static const soleAct s_acts[] = {
	// T01: nothing to do
	{ "T01", "idle", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 60, { 0 }, { 0 } },
	{ "T01", "walk", sole_gaitWalk, sole_rootStepped, { 0, -5.6, 0, 0, 1.4 }, 8, { 0 }, { 0 } },
	{ "T01", "run", sole_gaitRun, sole_rootStepped, { 0, -8, 0, 0, 4 }, 4, { 0 }, { 0 } },

	// T02, T03: stairs up and down, one tread a step, two, any; T06: ramped, over an invisible ramp through the nosings
	{ "T02", "0.52 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 0.52 }, 18.6, { 0 }, { .stride = 0.58 } },
	{ "T02", "0.52 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 0.52 }, 18.6, { 0 },
	    { .stride = 0.58, .corners = { 0.81, 4.3, 5.48, 8.97 } } },
	{ "T02", "1.04 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.04 }, 9.3, { 0 }, { .stride = 1.16 } },
	{ "T02", "1.04 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 1.04 }, 9.3, { 0 },
	    { .stride = 1.16, .corners = { 0.81, 4.3, 5.48, 8.97 } } },
	{ "T02", "1.40 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 }, { 0 } },
	{ "T02", "1.40 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .corners = { 0.81, 4.3, 5.48, 8.97 } } },
	{ "T03", "0.45 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 0.45 }, 19.5, { 0 }, { .stride = 0.5 } },
	{ "T03", "0.45 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 0.45 }, 19.5, { 0 },
	    { .stride = 0.5, .corners = { 0.85, 3.86, 5.04, 8.05 } } },
	{ "T03", "0.90 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 0.9 }, 9.7, { 0 }, { .stride = 1 } },
	{ "T03", "0.90 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 0.9 }, 9.7, { 0 },
	    { .stride = 1, .corners = { 0.85, 3.86, 5.04, 8.05 } } },
	{ "T03", "1.40 stepped", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.2, { 0 }, { 0 } },
	{ "T03", "1.40 ramped", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 1.4 }, 6.2, { 0 },
	    { .corners = { 0.85, 3.86, 5.04, 8.05 } } },

	// T04: across and along the same stairs
	{ "T04", "walk 30", sole_gaitWalk, sole_rootStepped, { -2.7, 0.9, 30, 0, 1.04 }, 10.2, { 0 }, { 0 } },
	{ "T04", "walk 45", sole_gaitWalk, sole_rootStepped, { -4.6, 0.9, 45, 0, 1.04 }, 12.5, { 0 }, { 0 } },
	{ "T04", "walk 60", sole_gaitWalk, sole_rootStepped, { -4.4, 0.9, 60, 0, 1.04 }, 9.6, { 0 }, { 0 } },
	{ "T04", "strafe 90", sole_gaitStrafe, sole_rootStepped, { -3, 3.235, 90, -90, 0.3 }, 8, { 0 }, { 0 } },
	{ "T04", "strafe up", sole_gaitStrafe, sole_rootStepped, { 0, 0.9, 0, -90, 0.3 }, 14, { 0 }, { 0 } },

	// T05
	{ "T02", "T05 stand", sole_gaitIdle, sole_rootStepped, { 0, 2.9, 0, 0, 0 }, 5.5, { solePlayOnTreads, 0, 40 },
	    { 0 } },

	// T07
	{ "T07", "up", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 1.04 }, 5.4, { 0 },
	    { .corners = { 0.81, 4.3, 5.5, 6.0 } } },
	{ "T07", "up slowly", sole_gaitWalk, sole_rootRamped, { 0, 0.9, 0, 0, 0.52 }, 10.5, { 0 },
	    { .stride = 0.58, .corners = { 0.81, 4.3, 5.5, 6.0 } } },

	// T08
	{ "T08", "up and down 0", sole_gaitWalk, sole_rootStepped, { 0, -2.1, 0, 0, 1.4 }, 4.4, { 0 }, { 0 } },
	{ "T08", "up and down 30", sole_gaitWalk, sole_rootStepped, { -1.7, -2.1, 30, 0, 1.4 }, 5, { 0 }, { 0 } },
	{ "T08", "up and down 60", sole_gaitWalk, sole_rootStepped, { -2.4, -1.1, 60, 0, 1.4 }, 4, { 0 }, { 0 } },
	{ "T08", "one foot up", sole_gaitIdle, sole_rootStepped, { 0, 0, 90, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T08", "stop on it", sole_gaitWalk, sole_rootStepped, { 0, -2.1, 0, 0, 1.4 }, 5, { solePlayToIdle, 1.55, 1 },
	    { .unlabelled = true } },

	// T09, T10
	{ "T09", "walk", sole_gaitWalk, sole_rootFixed, { 0, 0.9, 0, 0, 1.4 }, 6, { 0 }, { 0 } },
	{ "T09", "walk, root steps", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6, { 0 }, { 0 } },
	{ "T10", "walk", sole_gaitWalk, sole_rootFixed, { 0, 0.9, 0, 0, 1.4 }, 6, { 0 }, { 0 } },
	{ "T10", "stand over", sole_gaitIdle, sole_rootFixed, { 0, 1, 0, 0, 0 }, 4, { solePlayOverSlit, 0, 3 }, { 0 } },

	// T11: 20 m there and back over the top
	{ "T11-10", "up and down", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 14, { 0 }, { 0 } },
	{ "T11-10", "across", sole_gaitWalk, sole_rootStepped, { -3.2, 6, 90, 0, 1.4 }, 4.5, { 0 }, { 0 } },
	{ "T11-10", "diagonal", sole_gaitWalk, sole_rootStepped, { -2.8, 2.8, 45, 0, 1.4 }, 5.6, { 0 }, { 0 } },
	{ "T11-10", "stand", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayHeadings, 0, 8 }, { 0 } },
	{ "T11-20", "up and down", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 14, { 0 }, { 0 } },
	{ "T11-20", "across", sole_gaitWalk, sole_rootStepped, { -3.2, 6, 90, 0, 1.4 }, 4.5, { 0 }, { 0 } },
	{ "T11-20", "diagonal", sole_gaitWalk, sole_rootStepped, { -2.8, 2.8, 45, 0, 1.4 }, 5.6, { 0 }, { 0 } },
	{ "T11-20", "stand", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayHeadings, 0, 8 }, { 0 } },
	{ "T11-30", "up and down", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 14, { 0 }, { 0 } },
	{ "T11-30", "across", sole_gaitWalk, sole_rootStepped, { -3.2, 6, 90, 0, 1.4 }, 4.5, { 0 }, { 0 } },
	{ "T11-30", "diagonal", sole_gaitWalk, sole_rootStepped, { -2.8, 2.8, 45, 0, 1.4 }, 5.6, { 0 }, { 0 } },
	{ "T11-30", "stand", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayHeadings, 0, 8 }, { 0 } },
	{ "T11-45", "up and down", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 14, { 0 }, { 0 } },
	{ "T11-45", "across", sole_gaitWalk, sole_rootStepped, { -3.2, 6, 90, 0, 1.4 }, 4.5, { 0 }, { 0 } },
	{ "T11-45", "diagonal", sole_gaitWalk, sole_rootStepped, { -2.8, 2.8, 45, 0, 1.4 }, 5.6, { 0 }, { 0 } },
	{ "T11-45", "stand", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayHeadings, 0, 8 }, { 0 } },

	// T12, T13
	{ "T12", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 12, { 0 }, { 0 } },
	{ "T13", "climb beside", sole_gaitWalk, sole_rootStepped, { 0.448, 1, 0, 0, 1 }, 6.5, { solePlayToIdle, 3.4, 1 },
	    { .unlabelled = true } },
	{ "T13", "step out", sole_gaitStrafe, sole_rootStepped, { 0, 4.5, 90, -90, 0.3 }, 6.5,
	    { solePlaySidestep, 0.448, 1 }, { .unlabelled = true } },

	// T14: uphill on the left and on the right
	{ "T14-20", "stand left", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T14-20", "stand right", sole_gaitIdle, sole_rootStepped, { 0, 6, 180, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T14-20", "walk left", sole_gaitWalk, sole_rootStepped, { 0, 1, 0, 0, 1.4 }, 7, { 0 }, { 0 } },
	{ "T14-20", "walk right", sole_gaitWalk, sole_rootStepped, { 0, 11, 180, 0, 1.4 }, 7, { 0 }, { 0 } },
	{ "T14-30", "stand left", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T14-30", "stand right", sole_gaitIdle, sole_rootStepped, { 0, 6, 180, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T14-30", "walk left", sole_gaitWalk, sole_rootStepped, { 0, 1, 0, 0, 1.4 }, 7, { 0 }, { 0 } },
	{ "T14-30", "walk right", sole_gaitWalk, sole_rootStepped, { 0, 11, 180, 0, 1.4 }, 7, { 0 }, { 0 } },

	// T15
	{ "T15-60", "stand", sole_gaitIdle, sole_rootFixed, { 0, 5, 0, 0, 0 }, 4, { solePlayFeetIn, 0.053, 1 }, { 0 } },
	{ "T15-60", "walk", sole_gaitWalk, sole_rootFixed, { 0, 0.9, 0, 0, 1.4 }, 5.8, { 0 }, { 0 } },
	{ "T15-75", "stand", sole_gaitIdle, sole_rootFixed, { 0, 5, 0, 0, 0 }, 4, { solePlayFeetIn, 0.053, 1 }, { 0 } },
	{ "T15-75", "walk", sole_gaitWalk, sole_rootFixed, { 0, 0.9, 0, 0, 1.4 }, 5.8, { 0 }, { 0 } },

	// T16, T17
	{ "T16-1", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0, 0, 0, 1.4 }, 7.5, { solePlayCrossing, 0, 8 }, { 0 } },
	{ "T16-1", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 9, 10 }, { 0 } },
	{ "T16-2", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0, 0, 0, 1.4 }, 7.5, { solePlayCrossing, 0, 8 }, { 0 } },
	{ "T16-2", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 9, 10 }, { 0 } },
	{ "T16-3", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0, 0, 0, 1.4 }, 7.5, { solePlayCrossing, 0, 8 }, { 0 } },
	{ "T16-3", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 9, 10 }, { 0 } },
	{ "T16-4", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0, 0, 0, 1.4 }, 7.5, { solePlayCrossing, 0, 8 }, { 0 } },
	{ "T16-4", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 9, 10 }, { 0 } },
	{ "T16-5", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0, 0, 0, 1.4 }, 7.5, { solePlayCrossing, 0, 8 }, { 0 } },
	{ "T16-5", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 9, 10 }, { 0 } },
	{ "T17", "walk", sole_gaitWalk, sole_rootStepped, { 0, -4.2, 0, 0, 1.4 }, 6, { solePlayLanes, 1.1, 4 }, { 0 } },
	{ "T17", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySpots, 4.2, 12 }, { 0 } },

	// T18 to T20
	{ "T18", "nudged", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 5, { solePlayNudge, 0.001, 1 },
	    { .unlabelled = true } },
	{ "T18", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T19", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 12, { 0 }, { 0 } },
	{ "T20-low", "stand", sole_gaitIdle, sole_rootStepped, { 0, 5, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T20-low", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 5.6, { 0 }, { 0 } },
	{ "T20-high", "stand", sole_gaitIdle, sole_rootStepped, { 0, 5, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T20-high", "walk", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 5.6, { 0 }, { 0 } },

	// T21, T22
	{ "T21", "through", sole_gaitCrouchWalk, sole_rootStepped, { 0, 0.9, 0, 0, 0.8 }, 7.5, { 0 }, { .ceiling = 0.5 } },
	{ "T21", "on top", sole_gaitWalk, sole_rootStepped, { 0, 2.4, 0, 0, 1 }, 3.2, { 0 }, { 0 } },
	{ "T22", "under a bench", sole_gaitIdle, sole_rootStepped, { 0, 2.98, 0, 0, 0 }, 4, { 0 }, { .ceiling = 0.3 } },
	{ "T22", "crawlway", sole_gaitCrouchWalk, sole_rootStepped, { 0, 4.4, 0, 0, 0.8 }, 5.5, { 0 }, { .ceiling = 0.5 } },

	// T23 to T26
	{ "T23-15", "stand", sole_gaitIdle, sole_rootFixed, { 0, 0, 0, 0, 0 }, 5, { 0 }, { 0 } },
	{ "T23-50", "stand", sole_gaitIdle, sole_rootFixed, { 0, 0, 0, 0, 0 }, 5, { 0 }, { 0 } },
	{ "T24", "turn at the edge", sole_gaitIdle, sole_rootStepped, { 0, 1.9, 0, 0, 0 }, 6, { solePlaySpin, 4, 1 },
	    { 0 } },
	{ "T24-0", "turn at the edge", sole_gaitIdle, sole_rootStepped, { 0, 1.9, 0, 0, 0 }, 6, { solePlaySpin, 4, 1 },
	    { 0 } },
	{ "T25-12", "walk", sole_gaitWalk, sole_rootStepped, { 0, 1.5, 0, 0, 1 }, 5, { 0 }, { 0 } },
	{ "T25-20", "walk", sole_gaitWalk, sole_rootStepped, { 0, 1.5, 0, 0, 1 }, 5, { 0 }, { 0 } },
	{ "T25-12", "stand", sole_gaitIdle, sole_rootStepped, { 0, 4, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T25-20", "stand", sole_gaitIdle, sole_rootStepped, { 0, 4, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T26-17", "stand", sole_gaitIdle, sole_rootStepped, { 0, -0.156, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T26-50", "stand", sole_gaitIdle, sole_rootStepped, { 0, -0.156, 0, 0, 0 }, 4, { 0 }, { 0 } },

	// T27 to T30
	{ "T27-lift", "ride", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 9, { 0 }, { 0 } },
	{ "T27-slide", "ride", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlayRide, 0, 1 }, { 0 } },
	{ "T27-both", "ride", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 9, { solePlayRide, 0, 1 }, { 0 } },
	{ "T27-lift", "walk", sole_gaitWalk, sole_rootStepped, { 0, -0.7, 0, 0, 0.5 }, 2.8, { 0 }, { 0 } },
	{ "T28", "stand", sole_gaitIdle, sole_rootFixed, { 0, 0, 0, 0, 0 }, 6, { 0 }, { 0 } },
	{ "T29", "stand", sole_gaitIdle, sole_rootFixed, { 0, 0, 0, 0, 0 }, 6, { 0 }, { 0 } },
	{ "T30", "stand", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 6, { solePlayFall, 3, 1 }, { 0 } },
	{ "T30", "stand across", sole_gaitIdle, sole_rootStepped, { 0, 0, 90, 0, 0 }, 6, { solePlayFall, 3, 1 }, { 0 } },
	{ "T30", "tilt", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 2.9, { 0 }, { 0 } },
	{ "T30", "tilt across", sole_gaitIdle, sole_rootStepped, { 0, 0, 90, 0, 0 }, 2.9, { 0 }, { 0 } },

	// T31: comes into being where nothing is level
	{ "T11-30", "T31 spawn", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T02", "T31 spawn", sole_gaitIdle, sole_rootStepped, { 0, 3.1, 0, 0, 0 }, 4, { 0 }, { 0 } },
	{ "T28", "T31 spawn", sole_gaitIdle, sole_rootFixed, { 0, 0, 0, 0, 0 }, 4, { 0 }, { 0 } },

	// T32
	{ "T04", "T32 teleport", sole_gaitWalk, sole_rootStepped, { -5, 0.9, 0, 0, 1.4 }, 4, { solePlayTeleport, 1.3, 1 },
	    { 0 } },
	{ "T16", "T32 origin", sole_gaitWalk, sole_rootStepped, { 0, -4, 0, 0, 1.4 }, 4, { solePlayOrigin, 2, 1 }, { 0 } },
	{ "T16", "T32 rebase", sole_gaitWalk, sole_rootStepped, { 0, -4, 0, 0, 1.4 }, 4, { solePlayRebase, 2, 1 }, { 0 } },

	// T33
	{ "T11-20", "T33 jump", sole_gaitWalk, sole_rootStepped, { 0, 0.8, 0, 0, 1.4 }, 3, { solePlayJump, 0.9, 1 },
	    { .unlabelled = true } },
	{ "T02", "T33 jump", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 2.5, { solePlayJump, 0.6, 1 },
	    { .unlabelled = true } },

	// T34
	{ "T01", "T34 crouch 0.20", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 6, { solePlayCrouch, 0.2, 8 },
	    { 0 } },
	{ "T01", "T34 crouch 0.40", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 6, { solePlayCrouch, 0.4, 8 },
	    { 0 } },
	{ "T34", "crouch 0.20", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 6, { solePlayCrouch, 0.2, 3 }, { 0 } },
	{ "T34", "crouch 0.40", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 6, { solePlayCrouch, 0.4, 3 }, { 0 } },
	{ "T34", "crouch", sole_gaitCrouch, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayHeadings, 0, 3 }, { 0 } },

	// T35, T36
	{ "T11-20", "T35 by ramps", sole_gaitIdle, sole_rootStepped, { -0.2, 6, 0, 0, 0 }, 6, { solePlayWeight, 1, 1 },
	    { 0 } },
	{ "T11-20", "T35 at once", sole_gaitIdle, sole_rootStepped, { -0.2, 6, 0, 0, 0 }, 6, { solePlayWeight, 0, 1 },
	    { 0 } },
	{ "T11-20", "T36 foot jump", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayFootJump, 2, 1 },
	    { .unlabelled = true } },
	{ "T11-20", "T36 tap", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayTap, 2, 1 },
	    { .unlabelled = true } },
	{ "T11-20", "T36 miss", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { 0 },
	    { .blindFrom = 1.999, .blindUntil = 2.001 } },

	// T37, T38
	{ "T11-20", "T37 scale at once", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayScale, 0, 3 },
	    { 0 } },
	{ "T11-20", "T37 scale in 1 s", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 5, { solePlayScale, 1, 3 },
	    { 0 } },
	{ "T11-20", "T37 legs", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 4, { solePlayLegs, 0.2, 2 }, { 0 } },
	{ "T01", "T38 heels", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 6.5, { solePlayShoes, 0.08, 1 }, { 0 } },
	{ "T11-20", "T38 heels", sole_gaitIdle, sole_rootStepped, { 0, 6, 0, 0, 0 }, 6.5, { solePlayShoes, 0.08, 1 },
	    { 0 } },

	// T39, T40
	{ "T01", "T39 round in 0.5", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 3, { solePlaySpin, 0.5, 1 },
	    { 0 } },
	{ "T01", "T39 round in 1.0", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 3.5, { solePlaySpin, 1, 1 },
	    { 0 } },
	{ "T01", "T39 round in 2.0", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4.5, { solePlaySpin, 2, 1 },
	    { 0 } },
	{ "T01", "T39 to and fro", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 4, { solePlaySway, 1, 1 }, { 0 } },
	{ "T01", "T40 strafe 0.15", sole_gaitStrafe, sole_rootStepped, { -2, 0, 90, -90, 0.15 }, 6, { 0 }, { 0 } },
	{ "T01", "T40 strafe 0.30", sole_gaitStrafe, sole_rootStepped, { -2, 0, 90, -90, 0.3 }, 6, { 0 }, { 0 } },
	{ "T01", "T40 strafe 0.60", sole_gaitStrafe, sole_rootStepped, { -2, 0, 90, -90, 0.6 }, 6, { 0 }, { 0 } },
	{ "T01", "T40 swapped", sole_gaitStrafe, sole_rootStepped, { 0, 0, 90, -90, 0.6 }, 4, { solePlaySwap, 4, 1 },
	    { .unlabelled = true } },

	// T41: 1.55 and 2.55 strides are double support
	{ "T01", "T41 walk, stop", sole_gaitWalk, sole_rootStepped, { 0, -3, 0, 0, 1.3 }, 4, { solePlayStop, 2.52, 1 },
	    { 0 } },
	{ "T01", "T41 walk, idle", sole_gaitWalk, sole_rootStepped, { 0, -3, 0, 0, 1.3 }, 4, { solePlayToIdle, 2.5, 1 },
	    { .unlabelled = true } },
	{ "T01", "T41 run, stop", sole_gaitRun, sole_rootStepped, { 0, -8, 0, 0, 3.3 }, 5, { solePlayToIdle, 2.5, 1 },
	    { .unlabelled = true } },

	// T42
	{ "T11-20", "T42 sprint", sole_gaitRun, sole_rootStepped, { 0, 0.9, 0, 0, 6 }, 3.2, { 0 }, { 0 } },
	{ "T01", "T42 bend", sole_gaitRun, sole_rootStepped, { -6, -7, 0, 0, 6 }, 3, { solePlayBend, 1.2, 1 }, { 0 } },

	// T43
	{ "T01", "T43 lifted", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 24, { solePlayLift, 0.3, 1 }, { 0 } },
	{ "T01", "T43 hips aside", sole_gaitIdle, sole_rootStepped, { 0, 0, 0, 0, 0 }, 60, { solePlayHipsAside, 0.1, 1 },
	    { 0 } },

	// T44, beside the acts above at other rates
	{ "T02", "T44 root at 50 Hz", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .rate = 165, .rootRate = 50, .rootHeld = true } },
	{ "T16", "T44 root at 50 Hz", sole_gaitWalk, sole_rootStepped, { 0, -5, 0, 0, 1.4 }, 7, { 0 },
	    { .rate = 165, .rootRate = 50, .rootHeld = true } },

	// T45
	{ "T02", "T45 wild steps", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .step = soleGetWildStep } },
	{ "T02", "T45 hitch", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .step = soleGetHitchStep } },
	{ "T02", "T45 pause", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .step = soleGetPausedStep } },

	// T46
	{ "T02", "T46 1 frame late", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 }, { .late = 1 } },
	{ "T02", "T46 3 frames late", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 }, { .late = 3 } },
	{ "T16", "T46 3 frames late", sole_gaitWalk, sole_rootStepped, { 0, -5, 0, 0, 1.4 }, 7, { 0 }, { .late = 3 } },
	{ "T16", "T46 5 % dropped", sole_gaitWalk, sole_rootStepped, { 0, -5, 0, 0, 1.4 }, 7, { 0 }, { .dropped = 0.05 } },

	// T47
	{ "T02", "T47 root at 10 Hz", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .rootRate = 10 } },
	{ "T16", "T47 corrected, 10 Hz", sole_gaitWalk, sole_rootStepped, { 0, -5, 0, 0, 1.4 }, 7,
	    { solePlayCorrected, 0.1, 1 }, { .rootRate = 10, .unlabelled = true } },
	{ "T02", "T47 root at 20 Hz", sole_gaitWalk, sole_rootStepped, { 0, 0.9, 0, 0, 1.4 }, 6.9, { 0 },
	    { .rootRate = 20 } },
	{ "T16", "T47 corrected, 20 Hz", sole_gaitWalk, sole_rootStepped, { 0, -5, 0, 0, 1.4 }, 7,
	    { solePlayCorrected, 0.1, 1 }, { .rootRate = 20, .unlabelled = true } },

	// T48: once round; T49: 20 m from floor to top, for something that can
	{ "T48", "round", sole_gaitWalk, sole_rootAround, { 0, 0, 0, 0, 1.4 }, 26.9, { 0 }, { 0 } },
	{ "T49", "floor to ceiling", sole_gaitWalk, sole_rootAround, { 0, 0, 0, 0, 0.5 }, 40, { 0 }, { 0 } },
};

const soleAct* soleGetActs( int32_t* count )
{
	*count = (int32_t)( sizeof s_acts / sizeof s_acts[0] );
	return s_acts;
}
