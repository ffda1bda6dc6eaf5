// SPDX-License-Identifier: MIT
// The character in the user's hand: dragged over the ground with the pointer while it stands, turned and lifted.
import type { GroundShape } from './ground';
import { Dragger } from './input';
import { find } from './page';
import type { SceneChoices } from './scene-page';
import type { Session } from './session';
import type { Stage } from './stage';

const GRIP = 0.9; // of a leg length from what the camera looks at: there the character is taken

/// What is shown now.
export interface Held
{
	readonly choices: SceneChoices;
	readonly stage: Stage;
	readonly session: Session;
	readonly shape: GroundShape;
}

export class Hand
{
	constructor( private readonly held: Held )
	{
		new Dragger( find<HTMLCanvasElement>( 'canvas' ), ( event ) => this.grab( event ), ( event ) => this.drag( event ), () => undefined );
	}

	/// Is the character under the pointer, and does it stand to be dragged?
	private grab( event: PointerEvent ): boolean
	{
		const { choices, stage, session } = this.held;
		return choices.mode === 'stand' &&
			stage.pick( event.clientX, event.clientY ).ray.distanceToPoint( session.focus() ) < GRIP * session.legLength;
	}

	private drag( event: PointerEvent ): void
	{
		const { stage, session, shape } = this.held;
		const place = shape.pick( stage.pick( event.clientX, event.clientY ) );
		if ( place !== null )
		{
			session.walker.drag( place.x, place.z );
		}
	}

	/// Who stands. @param degrees to the left
	turn( degrees: number ): void
	{
		const { choices, session } = this.held;
		choices.heading += degrees;
		if ( choices.mode === 'stand' )
		{
			session.walker.root.heading = choices.heading * Math.PI / 180;
		}
	}

	/// Without automatic height. @param by metres
	lift( by: number ): void
	{
		this.held.session.walker.root.y += this.held.choices.height === 'none' ? by : 0;
	}
}
