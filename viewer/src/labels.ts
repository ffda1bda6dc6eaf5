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

export class Labels
{
	private readonly box = find( 'labels' );

	constructor( private readonly stage: Stage )
	{
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
				element.style.left = `${at.x}px`;
				element.style.top = `${at.y}px`;
			}
		} );
	}
}
