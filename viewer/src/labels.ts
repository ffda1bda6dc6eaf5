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

export class Labels
{
	private readonly box = find( 'labels' );

	constructor( private readonly stage: Stage )
	{
	}

	/// Whole in its own view, whichever way it would stand out of it.
	private put( element: HTMLElement, at: THREE.Vector2, view: number ): void
	{
		const width = this.stage.viewSize.x;
		element.style.maxWidth = `${Math.max( width - 2 * MARGIN, 0 )}px`;
		const half = 0.5 * element.offsetWidth;
		const [ least, most ] = [ view * width + half + MARGIN, ( view + 1 ) * width - half - MARGIN ];
		element.style.left = `${Math.max( Math.min( at.x, most ), least )}px`;
		element.style.top = `${at.y}px`;
	}

	show( labels: readonly Label[] ): void
	{
		while ( this.box.children.length > labels.length )
		{
			this.box.lastElementChild!.remove();
		}
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
