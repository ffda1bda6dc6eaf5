// SPDX-License-Identifier: MIT
// What is special about acts: each changes the moment of a plain walk or stand. World space, metres, seconds; `value`
// is the act's, and what it means is said here.
#ifndef SCENARIOS_ACT_PLAY_H
#define SCENARIOS_ACT_PLAY_H

#include "act.h"

/// Puts the root as far along a course as it has gone. @param course degrees
void soleSetPlace( const soleAct* act, double x, double z, double course, double way, soleSceneMoment* moment );
/// @return false, and a height of 0, where there is none
bool soleFindStageFloor( const soleAct* act, const soleStage* stage, double x, double z, double time, double* height );

// Where and which way: act_place.c

soleActPlay solePlayHeadings;  // take: headings by eighths of a turn
soleActPlay solePlayCrossing;  // take: the same, through x, z after half of the duration
soleActPlay solePlayOnTreads;  // take: 8 headings by 5 places 0.06 apart along z
soleActPlay solePlaySpots;     // take: anywhere within value
soleActPlay solePlayLanes;     // take: beside each other, value apart
soleActPlay solePlayOverSlit;  // take: feet over one of the trenches of T10
soleActPlay solePlayRide;      // rides on piece 1
soleActPlay solePlayFall;      // falls 0.8 deep from value on
soleActPlay solePlayLift;      // lifted and lowered by value at 0.1 m/s
soleActPlay solePlaySpin;      // once round in value
soleActPlay solePlaySway;      // 90 degrees to either side, value times a second
soleActPlay solePlayBend;      // a bend of 90 degrees at value
soleActPlay solePlayStop;      // slows down from value on, its clip with it
soleActPlay solePlayToIdle;    // the same, within a blend to idle
soleActPlay solePlaySwap;      // to and fro, value times a second
soleActPlay solePlaySidestep;  // value far, then idle
soleActPlay solePlayJump;      // off the ground for 0.5 s from value on
soleActPlay solePlayTeleport;  // 10 m at value, and says so
soleActPlay solePlayCorrected; // put right by value every 2 s

// What else the host changes: act_change.c

soleActPlay solePlayHipsAside; // hips off their feet by value
soleActPlay solePlayCrouch;    // take: headings; hips lower by value, and up again
soleActPlay solePlayOrigin;    // the world's origin goes by 10 km at value
soleActPlay solePlayRebase;    // the root goes by 1 m at value, the world pose stays
soleActPlay solePlayWeight;    // off and on again, moved aside meanwhile. 1: by ramps, 0: at once
soleActPlay solePlayFootJump;  // a foot is 0.3 off for the frame at value
soleActPlay solePlayTap;       // a foot makes two quick steps from value on
soleActPlay solePlayNudge;     // feet to and fro sideways by value at 2 Hz
soleActPlay solePlayFeetIn;    // feet nearer to the middle by value
soleActPlay solePlayScale;     // take: to half, equal, double size; within value from 1 s on
soleActPlay solePlayLegs;      // take: legs longer and shorter by that share within 1 s
soleActPlay solePlayShoes;     // high heels on and off, 0.3 s each

// Lengths of frames, s: act_change.c

double soleGetWildStep( int32_t frame );   // 5 to 250 ms
double soleGetHitchStep( int32_t frame );  // one of 1 s
double soleGetPausedStep( int32_t frame ); // 120 of no length

#endif
