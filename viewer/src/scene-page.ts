// SPDX-License-Identifier: MIT
// The first page of the panel: how the character goes, how many there are, and which stages are on.
import GUI, { type Controller } from 'lil-gui';
import { stageSwitches } from './settings';
import type { HeightMode, WalkMode } from './walker';

export interface SceneChoices
{
	mode: WalkMode;
	count: number;
	speed: number;
	height: HeightMode;
	weight: number;
	/// Of who stands, degrees.
	heading: number;
	follow: boolean;
	body: number;
	stages: Record<string, boolean>;
}

export function defaultSceneChoices(): SceneChoices
{
	return {
		mode: 'path', count: 1, speed: 1, height: 'ground', weight: 1, heading: 0, follow: true, body: 1,
		stages: Object.fromEntries( stageSwitches.map( ( stage ) => [ stage.name, true ] ) ),
	};
}

export interface SceneEvents
{
	/// Other bodies are needed.
	populate: () => void;
	/// Settings are not what they were.
	stages: () => void;
	/// The character is to be turned.
	turned: () => void;
	body: () => void;
}

function explain( controller: Controller, text: string ): Controller
{
	controller.domElement.title = text;
	return controller;
}

export class ScenePage
{
	private readonly gui: GUI;
	private readonly heading: Controller;

	constructor( page: HTMLElement, readonly choices: SceneChoices, events: SceneEvents )
	{
		this.gui = new GUI( { container: page, title: 'Scene' } );
		this.gui.domElement.querySelector( '.lil-title' )?.remove();
		const walk = this.gui.addFolder( 'Motion' );
		explain( walk.add( choices, 'mode', { 'along the way': 'path', 'by keys or gamepad': 'keys', 'stand, drag me': 'stand' } ).name( 'goes' ),
			'Along the scene\'s way; by arrow keys, WASD or a gamepad; or standing, to be dragged with the pointer.' )
			.onChange( () => { this.refresh(); events.populate(); } );
		explain( walk.add( choices, 'speed', 0.1, 2, 0.05 ).name( 'clip speed' ), 'How much faster or slower the clip is played.' );
		this.heading = explain( walk.add( choices, 'heading', -180, 180, 1 ).name( 'heading, °' ), 'Turns who stands. Q and E do the same.' )
			.onChange( events.turned );
		explain( walk.add( choices, 'height', { 'ground under the root': 'ground', 'what Sole tells': 'sole', 'none': 'none' } ).name( 'automatic height' ),
			'The root finds the ground by itself, as a capsule would; or moves by soleOutput.groundOffset; or stays as it is.' );
		explain( walk.add( choices, 'weight', 0, 1, 0.01 ).name( 'weight' ), 'How much Sole changes: 0 leaves the pose as it is.' );
		const look = this.gui.addFolder( 'Look' );
		explain( look.add( choices, 'count', 1, 200, 1 ).name( 'characters' ), 'So many walk at once.' ).onFinishChange( events.populate );
		explain( look.add( choices, 'body', 0, 1, 0.05 ).name( 'body' ), 'How solid the body is: bones are seen through it.' ).onChange( events.body );
		explain( look.add( choices, 'follow' ).name( 'camera follows' ), 'The camera goes along.' );
		const stages = this.gui.addFolder( 'Stages' );
		for ( const stage of stageSwitches )
		{
			explain( stages.add( choices.stages, stage.name ), stage.text ).onChange( events.stages );
		}
		this.refresh();
	}

	refresh(): void
	{
		this.heading.enable( this.choices.mode === 'stand' );
		this.gui.controllersRecursive().forEach( ( controller ) => controller.updateDisplay() );
	}
}
