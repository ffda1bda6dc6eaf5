// SPDX-License-Identifier: MIT
// A small drawing of what a setting changes, at its value: a leg from the side in a box of 128 by 104, 80 high from hip
// to ankle, and what the value does to it.

const WIDTH = 128;
const HEIGHT = 104;
const GROUND = 92;
const LEG = 76; // the drawing's leg length
const HIP = { x: 56, y: GROUND - LEG - 4 };

const ink = 'var(--soft)';
const strong = 'var(--accent)';

function line( x1: number, y1: number, x2: number, y2: number, color = ink, width = 2, dash = '' ): string
{
	return `<line x1="${x1.toFixed( 1 )}" y1="${y1.toFixed( 1 )}" x2="${x2.toFixed( 1 )}" y2="${y2.toFixed( 1 )}" stroke="${color}" ` +
		`stroke-width="${width}" stroke-linecap="round" ${dash === '' ? '' : `stroke-dasharray="${dash}"`}/>`;
}

function circle( x: number, y: number, r: number, color = ink, fill = 'none' ): string
{
	return `<circle cx="${x.toFixed( 1 )}" cy="${y.toFixed( 1 )}" r="${Math.max( r, 0 ).toFixed( 1 )}" stroke="${color}" stroke-width="1.5" fill="${fill}"/>`;
}

function path( d: string, color = strong, width = 2 ): string
{
	return `<path d="${d}" fill="none" stroke="${color}" stroke-width="${width}" stroke-linecap="round" stroke-linejoin="round"/>`;
}

function text( x: number, y: number, words: string ): string
{
	return `<text x="${x}" y="${y}" font-size="10" fill="${ink}" text-anchor="middle">${words}</text>`;
}

function ground( y = GROUND ): string
{
	return line( 6, y, WIDTH - 6, y, ink, 1.5 );
}

/// A leg whose ankle is so far from the hip, straight down, knee ahead; and its foot.
function leg( share: number, x = HIP.x, y = HIP.y, color = ink ): string
{
	const half = LEG / 2;
	const down = Math.min( Math.max( share, 0.05 ), 1 ) * LEG;
	const ahead = Math.sqrt( Math.max( half * half - down * down / 4, 0 ) );
	return path( `M${x} ${y} L${( x + ahead ).toFixed( 1 )} ${( y + down / 2 ).toFixed( 1 )} L${x} ${( y + down ).toFixed( 1 )}`, color, 3 ) +
		foot( x, y + down, 0, color );
}

/// A foot whose ankle is there, turned by an angle, toes up positive.
function foot( x: number, y: number, angle = 0, color = ink ): string
{
	const at = ( ax: number, ay: number ): string =>
	{
		const c = Math.cos( angle );
		const s = Math.sin( angle );
		return `${( x + ax * c + ay * s ).toFixed( 1 )} ${( y - ax * s + ay * c ).toFixed( 1 )}`;
	};
	return path( `M${at( 0, 0 )} L${at( -6, 4 )} L${at( 16, 4 )} Z`, color, 2 );
}

/// An error that dies away: half of it is left after the value.
function decay( halfLife: number ): string
{
	const span = 0.5;
	let d = 'M8 16';
	for ( let k = 0; k <= 40; ++k )
	{
		const t = span * k / 40;
		const phase = 1.678347 * t / Math.max( halfLife, 1e-4 );
		const left = halfLife > 0 ? ( 1 + phase ) * Math.exp( -phase ) : 0;
		d += ` L${( 8 + 112 * k / 40 ).toFixed( 1 )} ${( GROUND - 76 * left ).toFixed( 1 )}`;
	}
	const half = 8 + 112 * Math.min( halfLife / span, 1 );
	return ground() + line( half, GROUND, half, GROUND - 38, ink, 1, '3 3' ) + line( 8, GROUND - 38, half, GROUND - 38, ink, 1, '3 3' ) +
		path( d ) + text( 100, 28, '0.5 s' );
}

function duration( seconds: number, most: number ): string
{
	const span = Math.max( 0.25, Math.min( most, seconds * 2 ) );
	const end = 10 + 108 * Math.min( seconds / span, 1 );
	return line( 10, 60, 118, 60, ink, 2 ) + line( 10, 60, end, 60, strong, 6 ) + text( 108, 78, `${span.toFixed( 2 )} s` ) + text( 12, 78, '0' );
}

/// An angle of a slope, a foot on it.
function slope( angle: number ): string
{
	const dx = 104 * Math.cos( angle );
	const dy = 104 * Math.sin( angle );
	const scale = Math.min( 1, 78 / Math.max( dy, 1 ) );
	return ground() + line( 12, GROUND, 12 + dx * scale, GROUND - dy * scale, strong, 3 ) +
		foot( 12 + 0.45 * dx * scale - 3 * Math.sin( angle ), GROUND - 0.45 * dy * scale - 5, angle );
}

function bend( angle: number, sign: number ): string
{
	return ground() + foot( 44, 70, 0 ) + line( 60, 74, 60 + 34 * Math.cos( angle ), 74 - sign * 34 * Math.sin( angle ), strong, 4 ) +
		line( 60, 74, 96, 74, ink, 1, '3 3' );
}

/// A foot from above, and its turn.
function turned( angle: number ): string
{
	const degrees = -angle * 180 / Math.PI;
	const shape = 'M-8 26 Q-12 0 -9 -18 Q0 -34 9 -18 Q12 0 8 26 Q0 34 -8 26Z';
	return `<g transform="translate(64 56)"><path d="${shape}" fill="none" stroke="${ink}" stroke-dasharray="3 3"/>` +
		`<path d="${shape}" fill="none" stroke="${strong}" stroke-width="2" transform="rotate(${degrees.toFixed( 1 )})"/></g>`;
}

/// A length against the leg, upwards from the ground or down from it.
function height( length: number, sign = 1 ): string
{
	const size = Math.min( length * LEG, sign > 0 ? 90 : 40 );
	const base = sign > 0 ? GROUND : 52;
	const body = sign > 0 ? leg( 0.97 ) : leg( 0.97, HIP.x, HIP.y - 40 );
	return ground( base ) + body + line( 96, base, 96, base - sign * size, strong, 3 ) + line( 90, base - sign * size, 102, base - sign * size, strong, 3 );
}

/// How far a foot may be from where it is held: a ring from above.
function ring( length: number ): string
{
	return circle( 64, 52, 4, ink, ink ) + circle( 64, 52, Math.min( length * LEG, 50 ), strong ) + text( 64, 100, 'from above' );
}

function reach( share: number ): string
{
	return circle( HIP.x, HIP.y, LEG, ink ) + circle( HIP.x, HIP.y, share * LEG, strong ) + leg( share );
}

function shareBar( share: number, most: number ): string
{
	return line( 14, 52, 114, 52, ink, 8 ) + line( 14, 52, 14 + 100 * share / Math.max( most, 1e-6 ), 52, strong, 8 ) + text( 64, 78, `${( 100 * share ).toFixed( 0 )} %` );
}

function speed( value: number, most: number ): string
{
	const length = Math.min( 12 + 96 * value / Math.max( most, 1e-6 ), 108 );
	return ground() + foot( 34, 84, 0 ) + line( 14, 62, 14 + length, 62, strong, 3 ) +
		path( `M${8 + length} 57 L${14 + length} 62 L${8 + length} 67` );
}

function probes( layout: number ): string
{
	const across = [ [ 24, 40, 66, 66, 92 ], [ 18, 26, 34, 42, 50, 58, 66, 80, 94 ], [ 66 ] ][ layout ] ?? [];
	return ground() + path( 'M18 88 Q18 70 34 70 L70 70 L100 80 L100 88 Z', ink ) +
		across.map( ( x ) => line( x, 16, x, 88, strong, 1.5 ) ).join( '' );
}

function sphere( radius: number ): string
{
	const r = Math.min( radius * LEG, 30 );
	return ground() + line( 64, 12, 64, GROUND - r, ink, 1.5, '4 3' ) + circle( 64, GROUND - r, r, strong );
}

function pivot( value: number ): string
{
	return ground() + foot( 52, 80, 0 ) + circle( [ -20, 66, 52 ][ value ] ?? -20, 84, 5, strong, strong ) +
		text( 64, 30, [ 'heading held', 'ball', 'ankle' ][ value ] ?? '' );
}

function pelvis( length: number, sign: number ): string
{
	const shift = Math.min( length, 1 ) * LEG * 0.6 * sign;
	return ground() + leg( 0.97 ) + line( 96, HIP.y, 96, HIP.y + shift, strong, 3 ) + circle( 96, HIP.y + shift, 4, strong, strong ) +
		line( HIP.x, HIP.y, 112, HIP.y, ink, 1, '3 3' );
}

/// A foot that follows a steep slope no further than an angle.
function tilt( most: number ): string
{
	const steep = 0.8;
	const dx = 86 * Math.cos( steep );
	const dy = 86 * Math.sin( steep );
	return ground() + line( 24, GROUND, 24 + dx, GROUND - dy, ink, 3 ) +
		foot( 24 + 0.5 * dx, GROUND - 0.5 * dy - 6, Math.min( most, steep ), strong );
}

/// A sole so far over the ground, or below it.
function lifted( length: number ): string
{
	const y = 72 - length * LEG * 0.5;
	return ground( 76 ) + foot( 52, y, 0, strong ) + line( 96, 76, 96, y + 4, strong, 3 );
}

/// How much of the way from the animated foot to the placed one is gone, over ground of a height.
function kept( share: number, rise: number ): string
{
	const animated = 58;
	const placed = animated - rise;
	return ground() + line( 30, GROUND - rise, 98, GROUND - rise, ink, 3 ) + foot( 56, animated, 0, ink ) +
		foot( 56, animated + share * ( placed - animated ), 0, strong ) + text( 106, 20, `${( 100 * share ).toFixed( 0 )} %` );
}

/// Two feet on steps, and the line that the pelvis goes with.
function follow( kind: number ): string
{
	const feet = foot( 28, 86 ) + foot( 78, 62 ) + line( 6, GROUND, 64, GROUND, ink, 1.5 ) + line( 64, GROUND, 64, 68, ink, 1.5 ) + line( 64, 68, 122, 68, ink, 1.5 );
	const lines = [ line( 14, 48, 114, 24, strong, 3 ) + foot( 104, 44, 0, strong ), line( 30, 44, 80, 20, strong, 3 ), line( 14, 44, 114, 44, strong, 3 ) ];
	return feet + ( lines[ kind ] ?? '' );
}

/// What is moved by the pelvis' offset: its joint, all of the character, or nothing.
function mover( kind: number ): string
{
	const arrow = path( 'M104 30 L104 52 M99 47 L104 52 L109 47' );
	const body = leg( 0.9, HIP.x, HIP.y + 8, kind === 1 ? strong : ink );
	return ground() + body + circle( HIP.x, HIP.y + 8, 5, kind === 2 ? ink : strong, kind === 0 ? strong : 'none' ) + ( kind === 2 ? text( 104, 50, 'told' ) : arrow );
}

/// A foot of which one probe is left after a while.
function sleep( seconds: number ): string
{
	return seconds > 0 ? probes( 2 ) + text( 24, 26, `${seconds.toFixed( 1 )} s` ) : probes( 0 );
}

/// A share of what is left with every call, in steps; or all the time.
function smoothing( kind: number ): string
{
	const steps = [ 1, 0.5, 0.25, 0.125, 0.0625 ].map( ( left, k ) => `L${8 + 22 * k} ${GROUND - 76 * left} L${30 + 22 * k} ${GROUND - 76 * left}` ).join( ' ' );
	return kind > 0 ? ground() + path( `M8 16 ${steps}` ) + text( 96, 28, '0.02 s' ) : decay( 0.1 );
}

/// A leg on a high step beside one on the ground, and what is changed for it: a knee, the hips or the trunk.
function highStep( part: 'knee' | 'hips' | 'lean', value: number ): string
{
	const step = line( 6, GROUND, 70, GROUND, ink, 1.5 ) + line( 70, GROUND, 70, 68, ink, 1.5 ) + line( 70, 68, 122, 68, ink, 1.5 );
	const hips = part === 'hips' ? -60 * value : 0;
	const knee = part === 'knee' ? -16 * value : 0;
	const lean = part === 'lean' ? 26 * value : 0;
	return step + path( `M${52 + hips} 44 L54 68 L48 88` ) + foot( 48, 88 ) +
		path( `M${52 + hips} 44 L82 ${44 + knee} L80 ${64 + knee}`, part === 'knee' ? strong : ink ) + foot( 80, 64 + knee ) +
		line( 52 + hips, 44, 52 + hips + lean, 12, part === 'lean' ? strong : ink, 3 ) +
		circle( 52 + hips, 44, 4, part === 'hips' ? strong : ink, part === 'hips' ? strong : 'none' );
}

type Sketch = ( value: number, most: number ) => string;

const byName: Record<string, Sketch> = {
	'probe.shape': ( v ) => ( v > 0.5 ? sphere( 0.14 ) : probes( 2 ) ),
	'probe.layout': probes,
	'probe.radius': sphere,
	'probe.stepUp': ( v ) => height( v ),
	'probe.stepDown': ( v ) => height( v, -1 ),
	'probe.sleep': sleep,
	'support.filter': smoothing,
	'support.maxSlope': slope,
	'contact.pivot': pivot,
	'contact.lockDistance': ring,
	'contact.lockAngle': turned,
	'contact.replantDistance': ring,
	'contact.replantAngle': turned,
	'target.toeOutLeft': turned,
	'target.toeOutRight': ( v ) => turned( -v ),
	'target.align': ( v ) => slope( 0.4 ) + foot( 84, 40, 0.4 * v, strong ),
	'target.maxTilt': tilt,
	'target.height': lifted,
	'target.flight': ( v ) => kept( v, 22 ),
	'target.moving': ( v ) => kept( v, 22 ) + path( 'M12 20 L40 20 M34 15 L40 20 L34 25' ),
	'target.unreachable': ( v ) => kept( v, -22 ),
	'activity.running': ( v ) => kept( v, 22 ) + path( 'M12 20 L48 20 M42 15 L48 20 L42 25 M20 28 L36 28' ),
	'activity.airborne': ( v ) => kept( v, 22 ) + path( 'M20 40 L20 14 M15 20 L20 14 L25 20' ),
	'activity.low': lifted,
	'activity.high': lifted,
	'layer.knee': ( v ) => highStep( 'knee', v ),
	'layer.hips': ( v ) => highStep( 'hips', v ),
	'layer.lean': ( v ) => highStep( 'lean', v ),
	'pelvis.follow': follow,
	'pelvis.mode': mover,
	'pelvis.down': ( v ) => pelvis( v, 1 ),
	'pelvis.up': ( v ) => pelvis( v, -1 ),
	'leg.reach': reach,
	'leg.fold': reach,
	'leg.softZone': ( v ) => reach( 1 - v ),
	'leg.heelLift': ( v ) => ground() + foot( 58, 62, -v, strong ),
	'ankle.toeUp': ( v ) => bend( v, 1 ),
	'ankle.toeDown': ( v ) => bend( v, -1 ),
	'homebrew.raySphereRadius': sphere,
	'homebrew.ankleHeightOffset': lifted,
	'homebrew.worldHeightOffset': lifted,
	'homebrew.rayCastRange': ( v ) => height( v, -1 ),
	'homebrew.lengthFromHeelToToes': ring,
	'homebrew.smoothTime': decay,
	'homebrew.crouchRange': ( v ) => pelvis( v, 1 ),
	'homebrew.stretchRange': ( v ) => pelvis( v, -1 ),
	'iksetting.raycastDownDistance': ( v ) => height( v, -1 ),
	'iksetting.pelvisOffset': lifted,
	'iksetting.leftFootAngleOffset': turned,
	'iksetting.rightFootAngleOffset': ( v ) => turned( -v ),
	'effector.traceDistance': ( v ) => height( v, -1 ),
	'effector.footAdjustment': lifted,
	'ozz.footHeight': lifted,
	'ozz.soften': reach,
};

const byUnit: Record<string, Sketch> = {
	's': duration,
	'rad': slope,
	'L': ( v ) => height( v ),
	'L/s': speed,
	'1/s': ( v ) => ( v > 0 ? decay( Math.LN2 / v ) : shareBar( 1, 1 ) ),
	'': shareBar,
};

/// Other methods' units in those of the drawings, on a human's leg.
const scales: Record<string, readonly [ unit: string, scale: number ]> = { 'm': [ 'L', 1 / 0.9 ], 'cm': [ 'L', 1 / 90 ], 'deg': [ 'rad', Math.PI / 180 ] };

/// The inside of an svg element of 128 by 104.
export function sketchSetting( name: string, unit: string, value: number, most: number ): string
{
	const halfLife = /HalfLife$/.test( name ) || name === 'target.secondTime' || name === 'pelvis.release';
	const [ of, scale ] = scales[ unit ] ?? [ unit, 1 ];
	const draw = byName[ name ] ?? ( halfLife ? decay : byUnit[ of ] ?? shareBar );
	return draw( value * scale, most * scale );
}

export const SKETCH_BOX = `0 0 ${WIDTH} ${HEIGHT}`;
