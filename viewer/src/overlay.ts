// SPDX-License-Identifier: MIT
// What is drawn over the bodies: what each method shows of its frame, in the view that its body is in, words at the feet
// and problems where they are.
import * as THREE from 'three';
import type { Checks } from './checks';
import { Gizmos } from './gizmos';
import { Labels, type Label } from './labels';
import { find } from './page';
import type { Session } from './session';
import { LAYER_FIRST, LAYER_SECOND, type Stage } from './stage';

export class Overlay
{
	private readonly gizmos = [ LAYER_FIRST, LAYER_SECOND ].map( ( layer ) => new Gizmos( layer ) );
	private readonly labels: Labels;
	private texts: Label[] = [];

	constructor( stage: Stage, private readonly checks: Checks )
	{
		this.labels = new Labels( stage );
		stage.scene.add( ...this.gizmos.map( ( { group } ) => group ) );
	}

	/// Gizmos and texts of the frame as it is now. @param mask what is switched on
	refresh( session: Session, mask: number ): void
	{
		const shapes = session.shapes( mask );
		this.texts = this.gizmos.flatMap( ( gizmos, view ) => gizmos.draw( shapes[ view ] ?? [] ).map( ( shape ) =>
			( { place: new THREE.Vector3().fromArray( shape.a ), text: shape.text, kind: '', view } ) ) );
	}

	private findProblems( session: Session ): Label[]
	{
		const open = find( 'page-checks' ).hidden === false;
		const problems = open ? this.checks.problems : [];
		const { chosen } = this.checks;
		return [ ...new Set( chosen !== null ? [ ...problems, chosen ] : problems ) ].map( ( finding ) =>
		{
			const joint = finding.joint >= 0 ? finding.joint : session.rig.pelvis;
			return { place: session.hero.jointPlace( joint ), text: `${finding.where}: ${finding.what}`, kind: 'problem', view: session.heroView };
		} );
	}

	/// Words to where they belong in the picture as it is seen now.
	draw( session: Session ): void
	{
		this.labels.show( [ ...this.texts, ...this.findProblems( session ) ] );
	}
}
