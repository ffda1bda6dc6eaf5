// SPDX-License-Identifier: MIT
// The set-up check: what was found of the character and what is wrong with it, worst first; a finding that is chosen is
// shown where it happens.
import { find, make } from './page';

export type Severity = 'info' | 'warning' | 'error';

export interface Finding
{
	severity: Severity;
	where: string;
	what: string;
	mend: string;
	/// Index of the joint where it happens, or -1.
	joint: number;
}

const UNMET_TIME = 1; // s
const nothingMet: Finding = { severity: 'error', where: 'ground', joint: -1, what: 'no probe has met anything for more than a second',
	mend: 'the mask, the layer of the ground or the cast is wrong, or the character is nowhere near it: see probe.mask, probe.stepUp and probe.stepDown' };

const order: Record<Severity, number> = { error: 0, warning: 1, info: 2 };

export class Checks
{
	private readonly list = make( 'ul', { class: 'checks' } );
	findings: Finding[] = [];
	/// The one that is shown in the scene.
	chosen: Finding | null = null;

	constructor( page: HTMLElement, private readonly changed: () => void )
	{
		page.append( make( 'p', { class: 'note' }, 'What was found of the character, and what would keep its feet from ' +
			'the ground. Choose a line to see where it happens.' ), this.list );
	}

	/// All that is worth a look, for when the page is open.
	get problems(): Finding[]
	{
		return this.findings.filter( ( finding ) => finding.severity !== 'info' );
	}

	/// Ground that no probe ever meets is no gap: something is set wrong. @param unmetTime s, as the library tells it
	hear( unmetTime: number ): void
	{
		const others = this.findings.filter( ( finding ) => finding !== nothingMet );
		const unmet = unmetTime > UNMET_TIME;
		if ( unmet === ( others.length === this.findings.length ) )
		{
			this.show( unmet ? [ ...others, nothingMet ] : others );
		}
	}

	show( findings: readonly Finding[] ): void
	{
		const chosen = this.chosen;
		this.findings = [ ...findings ].sort( ( a, b ) => order[ a.severity ] - order[ b.severity ] );
		this.chosen = findings.find( ( finding ) => finding === chosen ) ?? null;
		this.list.replaceChildren( ...this.findings.map( ( finding ) => make( 'li', {}, this.makeRow( finding ) ) ) );
		const button = find( 'tab-checks' );
		button.querySelector( '.count' )?.remove();
		const count = this.problems.length;
		if ( count > 0 )
		{
			const worst = this.problems.some( ( finding ) => finding.severity === 'error' ) ? 'count bad' : 'count';
			button.append( make( 'span', { class: worst, title: `${count} to look at` }, String( count ) ) );
		}
	}

	private makeRow( finding: Finding ): HTMLElement
	{
		const lines = [ make( 'strong', {}, finding.where ), make( 'span', {}, finding.what ) ];
		if ( finding.mend !== '' )
		{
			lines.push( make( 'span', {}, `→ ${finding.mend}` ) );
		}
		const button = make( 'button', { class: finding.severity, 'aria-pressed': String( this.chosen === finding ), onclick: () =>
		{
			this.chosen = this.chosen === finding ? null : finding;
			this.list.querySelectorAll( 'button' ).forEach( ( other ) => other.setAttribute( 'aria-pressed', 'false' ) );
			button.setAttribute( 'aria-pressed', String( this.chosen === finding ) );
			this.changed();
		} }, ...lines );
		return button;
	}
}
