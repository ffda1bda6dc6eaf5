// SPDX-License-Identifier: MIT
// The table by which JavaScript finds the fields of structs in the module's memory, made by the compiler from the
// headers: where a struct changes, JavaScript follows. A module of its own, which make_layout.js asks while building.
#include "glue.h"

#include "sole/detect.h"
#include "sole/measure.h"
#include "sole/trace.h"

/// A row.
typedef struct soleWasmField
{
	const char* name; // "soleFrame.root", or "soleFrame" for the size of the whole
	uint32_t offset;
	uint32_t byteCount;
	/// f float, d double, i and u 32 bits, h 16 bits, b bool, c text, p pointer, s a struct or several
	uint32_t type;
} soleWasmField;

const soleWasmField* soleWasm_GetFields( void );
int32_t soleWasm_CountFields( void );

#define FIELD( type, field, letter )                                                                                   \
	{                                                                                                                  \
#type "." #field, offsetof( type, field ), sizeof( ( (type*)0 )->field ), letter                               \
	}
#define WHOLE( type )                                                                                                  \
	{                                                                                                                  \
#type, 0, sizeof( type ), 's'                                                                                  \
	}

static const soleWasmField soleWasmFields[] = {
	WHOLE( soleVersion ),
	WHOLE( soleMessage ),
	WHOLE( soleState ),
	WHOLE( soleSettings ),

	WHOLE( soleSettingInfo ),
	FIELD( soleSettingInfo, name, 'p' ),
	FIELD( soleSettingInfo, unit, 'p' ),
	FIELD( soleSettingInfo, type, 'i' ),
	FIELD( soleSettingInfo, minimum, 'd' ),
	FIELD( soleSettingInfo, maximum, 'd' ),
	FIELD( soleSettingInfo, defaultValue, 'd' ),
	FIELD( soleSettingInfo, text, 'p' ),

	WHOLE( soleLegDef ),
	FIELD( soleLegDef, name, 'p' ),
	FIELD( soleLegDef, side, 'i' ),
	FIELD( soleLegDef, joints, 'i' ),
	FIELD( soleLegDef, jointCount, 'i' ),
	FIELD( soleLegDef, hasVirtualAnkle, 'b' ),
	FIELD( soleLegDef, virtualAnkle, 'f' ),
	FIELD( soleLegDef, detachedFoot, 'i' ),
	FIELD( soleLegDef, toes, 'i' ),
	FIELD( soleLegDef, toeCount, 'i' ),
	FIELD( soleLegDef, hinge, 'f' ),
	FIELD( soleLegDef, sole, 'f' ),
	FIELD( soleLegDef, ankleLimits, 'f' ),

	WHOLE( soleRigDef ),
	FIELD( soleRigDef, jointCount, 'i' ),
	FIELD( soleRigDef, parents, 'p' ),
	FIELD( soleRigDef, bindPose, 'p' ),
	FIELD( soleRigDef, names, 'p' ),
	FIELD( soleRigDef, pelvis, 'i' ),
	FIELD( soleRigDef, up, 'f' ),
	FIELD( soleRigDef, forward, 'f' ),
	FIELD( soleRigDef, legs, 's' ),
	FIELD( soleRigDef, legCount, 'i' ),

	WHOLE( soleSkeleton ),
	FIELD( soleSkeleton, jointCount, 'i' ),
	FIELD( soleSkeleton, parents, 'p' ),
	FIELD( soleSkeleton, bindPose, 'p' ),
	FIELD( soleSkeleton, names, 'p' ),
	FIELD( soleSkeleton, roles, 'p' ),
	FIELD( soleSkeleton, skin, 'p' ),
	FIELD( soleSkeleton, skinCount, 'i' ),
	FIELD( soleSkeleton, samplePoses, 'p' ),
	FIELD( soleSkeleton, poseCount, 'i' ),
	FIELD( soleSkeleton, up, 'f' ),
	FIELD( soleSkeleton, forward, 'f' ),

	WHOLE( soleSkinVertex ),

	WHOLE( soleFinding ),
	FIELD( soleFinding, severity, 'i' ),
	FIELD( soleFinding, leg, 'i' ),
	FIELD( soleFinding, joint, 'i' ),
	FIELD( soleFinding, where, 'c' ),
	FIELD( soleFinding, what, 'c' ),
	FIELD( soleFinding, mend, 'c' ),

	WHOLE( soleDetectReport ),
	FIELD( soleDetectReport, findingCount, 'i' ),
	FIELD( soleDetectReport, truncated, 'b' ),
	FIELD( soleDetectReport, findings, 's' ),
	FIELD( soleDetectReport, legLength, 'f' ),
	FIELD( soleDetectReport, suggestedScale, 'f' ),

	WHOLE( soleSupport ),
	FIELD( soleSupport, surface, 'i' ),
	FIELD( soleSupport, transform, 'f' ),

	WHOLE( soleContactInput ),
	WHOLE( soleStepInput ),

	FIELD( soleFrame, root, 'f' ),
	FIELD( soleFrame, up, 'f' ),
	FIELD( soleFrame, timeStep, 'f' ),
	FIELD( soleFrame, weight, 'f' ),
	FIELD( soleFrame, secondPose, 'p' ),
	FIELD( soleFrame, supportCount, 'i' ),
	FIELD( soleFrame, clipFloor, 'f' ),
	FIELD( soleFrame, teleport, 'b' ),
	FIELD( soleFrame, worldOrigin, 'd' ),

	WHOLE( soleProbe ),
	FIELD( soleProbe, start_w, 'f' ),
	FIELD( soleProbe, direction_w, 'f' ),
	FIELD( soleProbe, length, 'f' ),
	FIELD( soleProbe, radius, 'f' ),
	FIELD( soleProbe, mask, 'u' ),
	FIELD( soleProbe, leg, 'h' ),
	FIELD( soleProbe, index, 'h' ),

	WHOLE( soleHit ),
	FIELD( soleHit, hit, 'b' ),
	FIELD( soleHit, startedInside, 'b' ),
	FIELD( soleHit, layer, 'u' ),
	FIELD( soleHit, surface, 'i' ),
	FIELD( soleHit, point_w, 'f' ),
	FIELD( soleHit, normal_w, 'f' ),
	FIELD( soleHit, velocity_w, 'f' ),
	FIELD( soleHit, size, 'f' ),
	FIELD( soleHit, asked_w, 'f' ),

	FIELD( soleOutput, pelvisOffset_w, 'f' ),
	FIELD( soleOutput, pelvisTranslation_l, 'f' ),
	FIELD( soleOutput, capsuleShorter, 'f' ),
	FIELD( soleOutput, capsuleOffset, 'f' ),
	FIELD( soleOutput, secondWeight, 'f' ),
	FIELD( soleOutput, groundOffset, 'f' ),
	FIELD( soleOutput, unmetTime, 'f' ),
	FIELD( soleOutput, activity, 'i' ),
	FIELD( soleOutput, strength, 'f' ),
	FIELD( soleOutput, lean_l, 'f' ),
	FIELD( soleOutput, bodyGradient_w, 'f' ),
	FIELD( soleOutput, legs, 's' ),

	WHOLE( soleLegOutput ),
	FIELD( soleLegOutput, flags, 'u' ),
	FIELD( soleLegOutput, rotations_l, 'f' ),
	FIELD( soleLegOutput, toeRotation_l, 'f' ),
	FIELD( soleLegOutput, footTranslation_l, 'f' ),
	FIELD( soleLegOutput, footRotation_l, 'f' ),
	FIELD( soleLegOutput, ankleTarget_w, 'f' ),
	FIELD( soleLegOutput, ankle_w, 'f' ),
	FIELD( soleLegOutput, planePoint_w, 'f' ),
	FIELD( soleLegOutput, planeNormal_w, 'f' ),
	FIELD( soleLegOutput, stretch, 'f' ),
	FIELD( soleLegOutput, error, 'f' ),
	FIELD( soleLegOutput, extension, 'f' ),
	FIELD( soleLegOutput, heightDemand, 'f' ),
	FIELD( soleLegOutput, plantWeight, 'f' ),
	FIELD( soleLegOutput, confidence, 'f' ),

	WHOLE( soleGroundMesh ),
	FIELD( soleGroundMesh, vertices, 'p' ),
	FIELD( soleGroundMesh, vertexCount, 'i' ),
	FIELD( soleGroundMesh, indices, 'p' ),
	FIELD( soleGroundMesh, triangleCount, 'i' ),
	FIELD( soleGroundMesh, triangleLayers, 'p' ),
	FIELD( soleGroundMesh, layer, 'u' ),
	FIELD( soleGroundMesh, surface, 'i' ),
	FIELD( soleGroundMesh, twoSided, 'b' ),

	WHOLE( soleHeightField ),
	FIELD( soleHeightField, origin, 'f' ),
	FIELD( soleHeightField, axisX, 'f' ),
	FIELD( soleHeightField, axisZ, 'f' ),
	FIELD( soleHeightField, up, 'f' ),
	FIELD( soleHeightField, cellX, 'f' ),
	FIELD( soleHeightField, cellZ, 'f' ),
	FIELD( soleHeightField, countX, 'i' ),
	FIELD( soleHeightField, countZ, 'i' ),
	FIELD( soleHeightField, heights, 'p' ),
	FIELD( soleHeightField, layer, 'u' ),
	FIELD( soleHeightField, surface, 'i' ),

	WHOLE( soleGroundPlane ),
	FIELD( soleGroundPlane, normal, 'f' ),
	FIELD( soleGroundPlane, offset, 'f' ),
	FIELD( soleGroundPlane, layer, 'u' ),
	FIELD( soleGroundPlane, surface, 'i' ),

	WHOLE( soleGroundDef ),
	FIELD( soleGroundDef, meshes, 'p' ),
	FIELD( soleGroundDef, meshCount, 'i' ),
	FIELD( soleGroundDef, heightFields, 'p' ),
	FIELD( soleGroundDef, heightFieldCount, 'i' ),
	FIELD( soleGroundDef, planes, 'p' ),
	FIELD( soleGroundDef, planeCount, 'i' ),

	WHOLE( soleGroundPiece ),
	FIELD( soleGroundPiece, ground, 'p' ),
	FIELD( soleGroundPiece, transform, 'f' ),
	FIELD( soleGroundPiece, velocity_w, 'f' ),
	FIELD( soleGroundPiece, spin_w, 'f' ),
	FIELD( soleGroundPiece, surface, 'i' ),

	WHOLE( soleMotion ),
	FIELD( soleMotion, rig, 'p' ),
	FIELD( soleMotion, frameCount, 'i' ),
	FIELD( soleMotion, frameRate, 'f' ),
	FIELD( soleMotion, poses, 'p' ),
	FIELD( soleMotion, roots, 'p' ),
	FIELD( soleMotion, up, 'f' ),
	FIELD( soleMotion, clipFloor, 'f' ),

	WHOLE( soleLabelDef ),
	FIELD( soleLabelDef, speedOn, 'f' ),
	FIELD( soleLabelDef, speedOff, 'f' ),
	FIELD( soleLabelDef, heightOn, 'f' ),
	FIELD( soleLabelDef, heightOff, 'f' ),
	FIELD( soleLabelDef, minimum, 'f' ),

	WHOLE( soleStep ),
	FIELD( soleStep, leg, 'i' ),
	FIELD( soleStep, strike, 'f' ),
	FIELD( soleStep, lift, 'f' ),
	FIELD( soleStep, heelDown, 'f' ),
	FIELD( soleStep, heelUp, 'f' ),
	FIELD( soleStep, toeDown, 'f' ),
	FIELD( soleStep, toeUp, 'f' ),
	FIELD( soleStep, place, 'f' ),
	FIELD( soleStep, forward, 'f' ),

	WHOLE( soleMeasurePoint ),
	WHOLE( soleMeasureDef ),
	FIELD( soleMeasureDef, motion, 'p' ),
	FIELD( soleMeasureDef, reference, 'p' ),
	FIELD( soleMeasureDef, labels, 'p' ),
	FIELD( soleMeasureDef, terrain, 'p' ),
	FIELD( soleMeasureDef, points, 'p' ),
	FIELD( soleMeasureDef, pointCount, 'i' ),
	FIELD( soleMeasureDef, skip, 'i' ),

	WHOLE( soleLegFigures ),
	FIELD( soleLegFigures, labelledFrames, 'i' ),
	FIELD( soleLegFigures, penetration, 'd' ),
	FIELD( soleLegFigures, verticalPenetration, 'd' ),
	FIELD( soleLegFigures, hover, 'd' ),
	FIELD( soleLegFigures, contactShare, 'd' ),
	FIELD( soleLegFigures, slide, 'd' ),
	FIELD( soleLegFigures, drift, 'd' ),
	FIELD( soleLegFigures, stances, 'i' ),
	FIELD( soleLegFigures, overExtended, 'i' ),
	FIELD( soleLegFigures, swings, 'i' ),
	FIELD( soleLegFigures, scuffs, 'i' ),
	FIELD( soleLegFigures, clearance, 'd' ),
	FIELD( soleLegFigures, kneeAccelerationRms, 'd' ),
	FIELD( soleLegFigures, kneeAccelerationMax, 'd' ),
	FIELD( soleLegFigures, largestJump, 'd' ),

	WHOLE( soleFigures ),
	FIELD( soleFigures, legCount, 'i' ),
	FIELD( soleFigures, legs, 's' ),
	FIELD( soleFigures, all, 's' ),
	FIELD( soleFigures, pelvisJerk, 'd' ),
	FIELD( soleFigures, pelvisLargestStep, 'd' ),
	FIELD( soleFigures, deviation, 'd' ),
	FIELD( soleFigures, pelvisOffsetRms, 'd' ),
	FIELD( soleFigures, pelvisOffsetMax, 'd' ),

	WHOLE( soleTraceSink ),
	WHOLE( soleTraceBuffer ),
	FIELD( soleTraceBuffer, bytes, 'p' ),
	FIELD( soleTraceBuffer, capacity, 'u' ),
	FIELD( soleTraceBuffer, byteCount, 'u' ),

	WHOLE( soleTraceReport ),
	FIELD( soleTraceReport, version, 'i' ),
	FIELD( soleTraceReport, legCount, 'i' ),
	FIELD( soleTraceReport, legNames, 'c' ),
	FIELD( soleTraceReport, frameCount, 'i' ),
	FIELD( soleTraceReport, differentFrames, 'i' ),
	FIELD( soleTraceReport, first, 's' ),
	FIELD( soleTraceDifference, frame, 'i' ),
	FIELD( soleTraceDifference, leg, 'i' ),
	FIELD( soleTraceDifference, field, 'p' ),
	FIELD( soleTraceDifference, component, 'i' ),
	FIELD( soleTraceDifference, recorded, 'u' ),
	FIELD( soleTraceDifference, replayed, 'u' ),

	WHOLE( soleDrawInfo ),
	FIELD( soleDrawInfo, category, 'u' ),
	FIELD( soleDrawInfo, name, 'p' ),
	FIELD( soleDrawInfo, text, 'p' ),

	FIELD( soleWasmCharacter, settings, 'p' ),
	FIELD( soleWasmCharacter, probeCount, 'i' ),
	FIELD( soleWasmCharacter, probeCapacity, 'i' ),
	FIELD( soleWasmCharacter, pose, 'p' ),
	FIELD( soleWasmCharacter, secondPose, 'p' ),
	FIELD( soleWasmCharacter, placed, 'p' ),
	FIELD( soleWasmCharacter, legWeight, 'p' ),
	FIELD( soleWasmCharacter, positionWeight, 'p' ),
	FIELD( soleWasmCharacter, rotationWeight, 'p' ),
	FIELD( soleWasmCharacter, contact, 'p' ),
	FIELD( soleWasmCharacter, steps, 'p' ),
	FIELD( soleWasmCharacter, supports, 'p' ),
	FIELD( soleWasmCharacter, probes, 'p' ),
	FIELD( soleWasmCharacter, hits, 'p' ),
	FIELD( soleWasmCharacter, frame, 's' ),
	FIELD( soleWasmCharacter, output, 's' ),
	FIELD( soleWasmCharacter, state, 's' ),

	WHOLE( soleDebugDraw ),
	WHOLE( soleWasmMarks ),
	FIELD( soleWasmMarks, marks, 'p' ),
	FIELD( soleWasmMarks, count, 'i' ),
	FIELD( soleWasmMarks, capacity, 'i' ),

	WHOLE( soleWasmMark ),
	FIELD( soleWasmMark, kind, 'i' ),
	FIELD( soleWasmMark, color, 'u' ),
	FIELD( soleWasmMark, category, 'u' ),
	FIELD( soleWasmMark, a_w, 'f' ),
	FIELD( soleWasmMark, b_w, 'f' ),
	FIELD( soleWasmMark, radius, 'f' ),
	FIELD( soleWasmMark, text, 'c' ),

};

const soleWasmField* soleWasm_GetFields( void )
{
	return soleWasmFields;
}

int32_t soleWasm_CountFields( void )
{
	return (int32_t)( sizeof soleWasmFields / sizeof soleWasmFields[0] );
}
