// SPDX-License-Identifier: MIT
// What the player does: keys and gamepad steer, the pointer drags the character over the ground.
import * as THREE from 'three';
import type { Steering } from './walker';

const DEAD_ZONE = 0.2; // of a stick
const wasd: Record<string, [ number, number ]> = {
	KeyW: [ 0, 1 ], ArrowUp: [ 0, 1 ], KeyS: [ 0, -1 ], ArrowDown: [ 0, -1 ],
	KeyA: [ -1, 0 ], ArrowLeft: [ -1, 0 ], KeyD: [ 1, 0 ], ArrowRight: [ 1, 0 ],
};

/// What has no use for keys of its own.
function isFree( target: EventTarget | null ): boolean
{
	return target === document.body || target instanceof HTMLCanvasElement;
}

export class Keys
{
	private readonly down = new Set<string>();

	/// @param commands by KeyboardEvent.code, for when nothing else has the keyboard
	constructor( private readonly commands: Record<string, () => void> )
	{
		addEventListener( 'keydown', ( event ) => this.press( event ) );
		addEventListener( 'keyup', ( event ) => this.down.delete( event.code ) );
		addEventListener( 'blur', () => this.down.clear() );
	}

	private press( event: KeyboardEvent ): void
	{
		if ( isFree( event.target ) === false || event.ctrlKey || event.metaKey || event.altKey )
		{
			return;
		}
		const command = this.commands[ event.code ];
		if ( command !== undefined && event.repeat === false )
		{
			command();
			event.preventDefault();
		}
		else if ( event.code in wasd )
		{
			this.down.add( event.code );
			event.preventDefault();
		}
	}

	private readStick(): [ number, number ]
	{
		for ( const pad of navigator.getGamepads() )
		{
			const x = pad?.axes[ 0 ] ?? 0;
			const y = -( pad?.axes[ 1 ] ?? 0 );
			if ( Math.hypot( x, y ) > DEAD_ZONE )
			{
				return [ x, y ];
			}
		}
		return [ 0, 0 ];
	}

	/// Where to, as seen by a camera: ahead is away from it.
	steer( camera: THREE.Camera ): Steering
	{
		let [ x, y ] = this.readStick();
		for ( const code of this.down )
		{
			x += wasd[ code ]![ 0 ];
			y += wasd[ code ]![ 1 ];
		}
		const ahead = camera.getWorldDirection( new THREE.Vector3() );
		const length = Math.hypot( x, y );
		return { amount: Math.min( length, 1 ), heading: Math.atan2( ahead.x, ahead.z ) - Math.atan2( x, y ) };
	}
}

/// Drags with the pointer what lies under it when it is pressed.
export class Dragger
{
	private dragging = false;

	/// @param grab is there something to drag? @param drag to under the pointer
	constructor( canvas: HTMLCanvasElement, grab: ( event: PointerEvent ) => boolean,
		drag: ( event: PointerEvent ) => void, ended: () => void )
	{
		// Before the camera's own listeners.
		canvas.addEventListener( 'pointerdown', ( event ) =>
		{
			if ( event.button === 0 && grab( event ) )
			{
				this.dragging = true;
				canvas.setPointerCapture( event.pointerId );
				event.stopImmediatePropagation();
			}
		}, { capture: true } );
		canvas.addEventListener( 'pointermove', ( event ) =>
		{
			if ( this.dragging )
			{
				drag( event );
				event.stopImmediatePropagation();
			}
		}, { capture: true } );
		const end = (): void =>
		{
			if ( this.dragging )
			{
				this.dragging = false;
				ended();
			}
		};
		canvas.addEventListener( 'pointerup', end );
		canvas.addEventListener( 'pointercancel', end );
	}
}
