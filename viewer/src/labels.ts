// SPDX-License-Identifier: MIT
// Words at places of the scene, as elements of the page.
import * as THREE from 'three';
import { find, make } from './page';
import type { Stage } from './stage';

export interface Label
{
	place: THREE.Vector3;
	text: string;
	kind: string;
	/// Which view it belongs to.
	view: number;
}

const MARGIN = 4; // pixels, to the edge of the view
const GAP = 2; // between two

/// Where a label is already. Pixels.
interface Box
{
	left: number;
	right: number;
	top: number;
	bottom: number;
}

export class Labels
{
	private readonly box = find( 'labels' );
	private boxes: Box[] = [];

	constructor( private readonly stage: Stage )
	{
	}

	/// Whole in its own view, whichever way it would stand out of it, and on no other.
	private put( element: HTMLElement, at: THREE.Vector2, view: number ): void
	{
		const width = this.stage.viewSize.x;
		element.style.maxWidth = `${Math.max( width - 2 * MARGIN, 0 )}px`;
		const half = 0.5 * element.offsetWidth;
		const [ least, most ] = [ view * width + half + MARGIN, ( view + 1 ) * width - half - MARGIN ];
		const x = Math.max( Math.min( at.x, most ), least );
		const box = { left: x - half, right: x + half, top: at.y, bottom: at.y + element.offsetHeight + GAP };
		// Below those that are there before it, from the highest on.
		for ( const other of this.boxes )
		{
			if ( box.left < other.right && box.right > other.left && box.top < other.bottom && box.bottom > other.top )
			{
				box.bottom += other.bottom - box.top;
				box.top = other.bottom;
			}
		}
		this.boxes.push( box );
		this.boxes.sort( ( a, b ) => a.top - b.top );
		element.style.left = `${x}px`;
		element.style.top = `${box.top}px`;
	}

	show( labels: readonly Label[] ): void
	{
		while ( this.box.children.length > labels.length )
		{
			this.box.lastElementChild!.remove();
		}
		this.boxes = [];
		labels.forEach( ( label, index ) =>
		{
			const element = ( this.box.children[ index ] ?? this.box.appendChild( make( 'span' ) ) ) as HTMLElement;
			const at = this.stage.project( label.place, label.view );
			element.hidden = at === null;
			element.className = label.kind;
			if ( element.textContent !== label.text )
			{
				element.textContent = label.text;
			}
			if ( at !== null )
			{
				this.put( element, at, label.view );
			}
		} );
	}
}
