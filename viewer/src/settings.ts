// SPDX-License-Identifier: MIT
// Settings as the page keeps them: values by dotted names, what was changed, presets, and stages that are switched off.
import effector from '../../settings/effector.json';
import homebrew from '../../settings/homebrew.json';
import ikSetting from '../../settings/iksetting.json';
import ozz from '../../settings/ozz.json';
import steps from '../../settings/steps.json';
import type { SettingInfo, SettingValues } from './library';

export function defaultsOf( infos: readonly SettingInfo[] ): SettingValues
{
	return Object.fromEntries( infos.map( ( info ) => [ info.name, info.default ] ) );
}

export function sameSettings( a: SettingValues, b: SettingValues ): boolean
{
	return Object.keys( a ).every( ( name ) => a[ name ] === b[ name ] );
}

/// What differs from the defaults.
export function changesOf( infos: readonly SettingInfo[], values: SettingValues ): SettingValues
{
	return Object.fromEntries( infos.filter( ( info ) => values[ info.name ] !== info.default )
		.map( ( info ) => [ info.name, values[ info.name ]! ] ) );
}

// --------------------------------------------------------------------------------------------------------- presets

export interface Preset
{
	name: string;
	values: SettingValues;
}

/// Settings of a file by their dotted names.
export function flatten( stages: Record<string, Record<string, number>> ): SettingValues
{
	return Object.fromEntries( Object.entries( stages ).flatMap( ( [ stage, fields ] ) =>
		Object.entries( fields ).map( ( [ field, value ] ) => [ `${stage}.${field}`, value ] ) ) );
}

/// Settings by their dotted names as a file has them.
export function nest( values: SettingValues ): Record<string, Record<string, number>>
{
	const stages: Record<string, Record<string, number>> = {};
	for ( const [ name, value ] of Object.entries( values ) )
	{
		const [ stage, field ] = name.split( '.' ) as [ string, string ];
		( stages[ stage ] ??= {} )[ field ] = value;
	}
	return stages;
}

/// What is not named keeps its default.
export const presets: readonly Preset[] = [
	{ name: 'Defaults', values: {} },
	{ name: 'Close-up: closest to the ground', values: { 'probe.layout': 1, 'support.plantedHalfLife': 0.01, 'contact.captureHalfLife': 0.03 } },
	{ name: 'Distant: cheapest', values: { 'probe.layout': 2, 'support.lookAhead': 0, 'foothold.shift': 0 } },
	{ name: 'Loose: keeps the animation', values: { 'target.align': 0.5, 'contact.lockDistance': 0.08, 'pelvis.speed': 0.5, 'foothold.shift': 0.05 } },
	{ name: 'Heavy: slow body', values: { 'pelvis.halfLife': 0.16, 'pelvis.release': 0.45, 'pelvis.speed': 0.6, 'contact.replantTime': 0.4 } },
	{ name: 'Nimble: quick body', values: { 'pelvis.halfLife': 0.04, 'pelvis.hold': 0.4, 'contact.releaseHalfLife': 0.04, 'contact.replantTime': 0.18 } },
	{ name: 'Rough ground: spheres', values: { 'probe.shape': 1, 'probe.radius': 0.04, 'probe.stepUp': 0.7, 'probe.stepDown': 0.8 } },
	{ name: 'High steps: knees, hips and trunk', values: flatten( steps ) },
	{ name: 'As Homebrew Foot IK', values: flatten( homebrew ) },
	{ name: 'As IKSetting', values: flatten( ikSetting ) },
	{ name: 'As And I Must Scream', values: flatten( effector ) },
	{ name: 'As the ozz sample', values: flatten( ozz ) },
];

// ---------------------------------------------------------------------------------------------------------- stages

/// A stage and the settings with which it does nothing.
export interface StageSwitch
{
	name: string;
	text: string;
	off: SettingValues;
}

export const stageSwitches: readonly StageSwitch[] = [
	{ name: 'look ahead', text: 'Feet in flight rise for what they will pass over.', off: { 'support.lookAhead': 0 } },
	{ name: 'foothold', text: 'Steps are shifted to where the sole stands well.', off: { 'foothold.shift': 0 } },
	{ name: 'lock', text: 'Planted feet are held in place.', off: { 'contact.lockDistance': 0, 'contact.lockAngle': 0 } },
	{ name: 'step over', text: 'Feet at rest that were left behind step over.', off: { 'contact.replantDistance': 2, 'contact.replantAngle': 3 } },
	{ name: 'align', text: 'Feet follow the slope of the ground.', off: { 'target.align': 0 } },
	{ name: 'pelvis', text: 'The pelvis moves so that all legs reach.', off: { 'pelvis.down': 0, 'pelvis.up': 0 } },
	{ name: 'heel lift', text: 'A heel is raised before a leg is overstretched.', off: { 'leg.heelLift': 0 } },
	{ name: 'soft reach', text: 'A leg that becomes straight slows down before it is.', off: { 'leg.softZone': 0 } },
	{ name: 'toes', text: 'Toes bend to the ground before them.', off: { 'ankle.toeUp': 0, 'ankle.toeDown': 0 } },
];

/// Settings with some stages switched off. @param on by the names of stageSwitches
export function applySwitches( values: SettingValues, on: Record<string, boolean> ): SettingValues
{
	const result = { ...values };
	for ( const stage of stageSwitches )
	{
		Object.assign( result, on[ stage.name ] === false ? stage.off : {} );
	}
	return result;
}
