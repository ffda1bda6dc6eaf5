// SPDX-License-Identifier: MIT
// The systems that Sole is compared with, in a module of their own that is loaded when one of them is first asked for.
// They get the frame that Sole gets.
import { loadMethods, type MethodCharacter, type MethodName, type Methods } from '../../build/wasm/page/methods.js';
import methodModule from '../../build/wasm/page/sole-methods.wasm?url';
import type { Rig } from '../../build/wasm/sole.js';
import type { GroundShape } from './ground';
import { GroundHandle } from './ground-handle';
import type { FootPlacer, Frame, Listener, RigHandle, SettingInfo, SettingValues, Shape } from './library';

export type { MethodName };

let methods: Methods | null = null;

export async function openMethods(): Promise<void>
{
	methods ??= await loadMethods( { url: new URL( methodModule, document.baseURI ) } );
}

/// Rig and ground of a session in the methods' own module.
export class MethodWorld
{
	readonly rig: Rig;
	readonly ground: GroundHandle;

	constructor( rig: RigHandle, shape: GroundShape )
	{
		if ( methods === null )
		{
			throw new Error( 'methods: are not loaded' );
		}
		this.rig = methods.createRig( rig.rig.definition );
		this.ground = new GroundHandle( methods, shape.parts, shape.twoSided );
	}

	makeCharacter( method: MethodName ): MethodCharacter
	{
		return methods!.createCharacter( this.rig, method );
	}

	/// The table of a method's own settings, with what was fitted to the character for defaults.
	ownInfos( method: MethodName ): readonly SettingInfo[]
	{
		const character = this.makeCharacter( method );
		const infos = character.ownInfos;
		character.dispose();
		return infos;
	}

	dispose(): void
	{
		this.ground.dispose();
		this.rig.dispose();
	}
}

/// Places the feet of one character as one of them does.
export class MethodPlacer implements FootPlacer
{
	readonly cost = [ 0, 0, 0 ];
	readonly told = null;
	private readonly character: MethodCharacter;

	/// @param listener hears what the clip tells of its steps, for it is told in Sole's own module
	constructor( private readonly world: MethodWorld, method: MethodName, private readonly listener: Listener )
	{
		this.character = world.makeCharacter( method );
	}

	/// A frame that begins anew says so: nothing is left of the ones before.
	forget(): void
	{
	}

	place( pose: Float32Array, frame: Frame ): void
	{
		const { character } = this;
		const { tell, ...said } = frame;
		character.pose = pose;
		Object.assign( character.frame, said );
		const heard = this.listener.hear( tell );
		character.contact.set( heard.contact );
		character.steps.set( heard.steps );
		character.gather();
		character.cast( this.world.ground.answers );
		character.solve();
		pose.set( character.placed );
	}

	flags( leg: number ): number
	{
		return this.character.output.legs[ leg ]!.flags;
	}

	ankle( leg: number ): number[]
	{
		return Array.from( this.character.output.legs[ leg ]!.ankle );
	}

	draw( mask: number ): Shape[]
	{
		return this.character.draw( mask );
	}

	setOwn( values: SettingValues ): void
	{
		Object.entries( values ).forEach( ( [ name, value ] ) => this.character.setOwn( name, value ) );
	}

	beginTrace(): void
	{
	}

	endTrace(): Uint8Array
	{
		return new Uint8Array();
	}

	dispose(): void
	{
		this.listener.dispose();
		this.character.dispose();
	}
}
