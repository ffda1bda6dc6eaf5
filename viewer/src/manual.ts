// SPDX-License-Identifier: MIT
// What scripts and tests may do with the page: window.viewer. Times and places are those of the scene.
import type { FootReport } from './body';
import type { FootFigures } from './plots';
import type { StageTime } from './stage-times';
import type { Load, Viewer } from './viewer';

export interface ManualViewer
{
	/// To the frame at a time, and shows it.
	stepTo( time: number ): void;
	/// Every leg of the body that is looked at.
	feet(): FootReport[];
	/// What the plots show of it.
	figures(): FootFigures[];
	/// World place of the root.
	root(): number[];
	/// Settings that differ from the defaults.
	changes(): Record<string, number>;
	/// What `sole replay` reads: all frames from the start to a time.
	trace( time: number ): Uint8Array;
	/// Microseconds a frame of each stage, while they are measured.
	stageTimes(): StageTime[];
	/// What frames cost, as a mean over some: without the graphics card's share.
	load( frames: number ): Load;
	/// What the set-up check says now.
	findings(): string[];
	/// The picture, as an address of a PNG.
	picture(): string;
	shown(): { character: string; ground: string; characters: number; methods: string[] };
	time(): number;
	/// Names of what there is to choose from.
	grounds(): string[];
	drawings(): string[];
	settings(): string[];
}

declare global
{
	interface Window
	{
		viewer?: ManualViewer;
	}
}

export function offerManual( viewer: Viewer ): void
{
	window.viewer = {
		stepTo: ( time ) => viewer.stepTo( time ),
		feet: () => viewer.session.hero.report(),
		figures: () => viewer.session.figures(),
		root: () => { const { x, y, z } = viewer.session.walker.root; return [ x, y, z ]; },
		changes: () => viewer.settings.changes,
		trace: ( time ) => viewer.record( time ),
		stageTimes: () => viewer.stageTimes.times.map( ( time ) => ( { ...time } ) ),
		load: ( frames ) => viewer.measureLoad( frames ),
		findings: () => viewer.checks.findings.map( ( finding ) => `${finding.severity} ${finding.where}: ${finding.what}` ),
		picture: () => viewer.picture(),
		shown: () => ( { character: viewer.session.model.name, ground: viewer.session.shape.name, characters: viewer.session.choices.count,
			methods: [ ...viewer.session.choices.methods ] } ),
		time: () => viewer.session.time,
		grounds: () => viewer.samples.filter( ( sample ) => sample.kind === 'ground' ).map( ( sample ) => sample.name ),
		drawings: () => viewer.library.drawInfos.map( ( info ) => info.name ),
		settings: () => viewer.library.settingInfos.map( ( info ) => info.name ),
	};
	document.documentElement.dataset[ 'ready' ] = 'true';
}
