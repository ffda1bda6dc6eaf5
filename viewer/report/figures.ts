// SPDX-License-Identifier: MIT
// Figures of two takes beside what is wanted of them, and the settings that were changed, as tables.
import { find, make } from '../src/page';
import type { Cell, Change, Row, Walk } from './data';

function sayNumber( value: number | null, row: Row ): string
{
	return value === null ? '–' : value.toFixed( row.decimals );
}

function makeCell( cell: Cell, row: Row ): HTMLTableCellElement
{
	const missed = cell.holds === false;
	return make( 'td', { class: missed ? 'missed' : cell.holds === true ? 'held' : '' }, sayNumber( cell.value, row ),
		make( 'span', { class: 'mark', title: missed ? 'misses its target' : '' }, missed ? '!' : '' ) );
}

/// Limits can be a multiple of the clip's own figure, which is the same for all takes.
function sayTarget( row: Row ): string
{
	const limit = row.cells.find( ( cell ) => cell.limit !== null )?.limit;
	if ( limit === undefined || limit === null )
	{
		return '';
	}
	return `${row.atLeast ? '≥' : limit === 0 ? '=' : '≤'} ${limit.toFixed( row.decimals )}`;
}

/// @param shown the two takes
export function showFigures( walk: Walk, shown: readonly [ number, number ] ): void
{
	const rows = walk.rows.filter( ( row ) => shown.some( ( take ) => row.cells[ take ]!.value !== null ) );
	const head = make( 'tr', {}, make( 'th', { scope: 'col' }, 'Figure' ),
		...shown.map( ( take, index ) => make( 'th', { scope: 'col', class: index === 0 ? 'before' : 'after' }, walk.takes[ take ]!.method ) ),
		make( 'th', { scope: 'col' }, 'target' ) );
	const body = rows.map( ( row ) => make( 'tr', {},
		make( 'th', { scope: 'row' }, row.title, make( 'span', { class: 'soft' }, row.unit === '' ? '' : `, ${row.unit}` ) ),
		...shown.map( ( take ) => makeCell( row.cells[ take ]!, row ) ),
		make( 'td', { class: 'soft' }, sayTarget( row ) ) ) );
	const judged = walk.rows.map( ( row ) => row.cells[ shown[ 1 ] ]!.holds ).filter( ( holds ) => holds !== null );
	const held = judged.filter( ( holds ) => holds ).length;
	find( 'figures' ).replaceChildren( make( 'h2', {}, 'Figures' ),
		make( 'p', { class: 'note' }, `Over all feet, without the first ${walk.skip} frames. Of ${judged.length} targets ` +
			`${walk.takes[ shown[ 1 ] ]!.method} holds ${held}; what misses its target is marked with !. Ratios are to the clip on flat ground.` ),
		make( 'div', { class: 'table' }, make( 'table', {}, make( 'thead', {}, head ), make( 'tbody', {}, ...body ) ) ) );
}

export function showChanges( changes: readonly Change[] ): void
{
	const number = ( value: number ): string => String( Number( value.toPrecision( 4 ) ) );
	const rows = changes.map( ( change ) => make( 'tr', {}, make( 'th', { scope: 'row', class: 'name' }, change.name ),
		make( 'td', {}, number( change.value ) ), make( 'td', { class: 'soft' }, number( change.default ) ),
		make( 'td', { class: 'soft unit' }, change.unit ), make( 'td', { class: 'text' }, change.text ) ) );
	const head = make( 'tr', {}, ...[ 'Setting', 'value', 'default', 'unit', 'what it does' ].map( ( title ) => make( 'th', { scope: 'col' }, title ) ) );
	find( 'settings' ).replaceChildren( make( 'h2', {}, 'Settings' ), changes.length === 0
		? make( 'p', { class: 'note' }, 'All settings are the defaults.' )
		: make( 'div', { class: 'table' }, make( 'table', {}, make( 'thead', {}, head ), make( 'tbody', {}, ...rows ) ) ) );
}
