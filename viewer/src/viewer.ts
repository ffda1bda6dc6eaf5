// SPDX-License-Identifier: MIT
// The page as a whole: holds what is loaded, makes the session anew when that changes, runs time, and hands the outcome
// to everything that shows it.
import { readAddress, writeAddress, type Address } from './address';
import { CharacterModel } from './character';
import { Checks } from './checks';
import { fetchSample, openFile, parseGlb, type Opened, type Sample } from './files';
import { GroundShape } from './ground';
import { Hand } from './hand';
import { Keys } from './input';
import { openMethods, type MethodName } from './methods';
import { FEET_LAYERS } from './motion';
import type { Library } from './library';
import { Overlay } from './overlay';
import { addTab, find, forgetMessages, make, messageOf, say, setTheme } from './page';
import { methodLabels, Pickers, readMethods } from './pickers';
import { Plots } from './plots';
import { ScenePage, defaultSceneChoices, type SceneChoices } from './scene-page';
import { needsMethods, Session } from './session';
import { applySwitches } from './settings';
import { hasOwnSettings, SettingsPage } from './settings-page';
import { ShowPage } from './show-page';
import { LAYER_FIRST, LAYER_SECOND, Stage } from './stage';
import { StageTimes } from './stage-times';
import { TIME_STEP, Transport } from './transport';
import type { Steering } from './walker';

const MOST_STEPS = 4; // of a picture: a page that is too slow falls behind instead of stopping
const TURN_STEP = 5; // degrees
const LIFT = 1.5; // m/s, of who is lifted by the keys

/// Milliseconds a frame of script, and of the library a character in that; draw calls and triangles of a picture.
export interface Load
{
	script: number;
	solver: number;
	calls: number;
	triangles: number;
}

export class Viewer
{
	readonly address: Address = readAddress( location.search );
	readonly stage: Stage;
	readonly settings: SettingsPage;
	readonly choices: SceneChoices = defaultSceneChoices();
	session!: Session;
	private readonly transport: Transport;
	private readonly pickers: Pickers;
	private readonly scenePage: ScenePage;
	private readonly showPage: ShowPage;
	readonly checks: Checks;
	private readonly plots = new Plots();
	readonly stageTimes = new StageTimes();
	private readonly overlay: Overlay;
	private readonly keys: Keys;
	private readonly hand = new Hand( this );
	private model!: CharacterModel;
	shape!: GroundShape;
	private behind = 0; // s that have not been stepped yet
	private recording = false;
	private costs = [ 0, 0, 0 ];
	private framesPerSecond = 60;

	constructor( readonly library: Library, readonly samples: readonly Sample[] )
	{
		if ( this.address.theme === 'dark' || this.address.theme === 'light' )
		{
			setTheme( this.address.theme );
		}
		this.stage = new Stage( find<HTMLCanvasElement>( 'canvas' ), this.address.manual );
		this.transport = new Transport( () => this.advance( 1 ), () => this.restart(), this.stageTimes.button );
		this.pickers = new Pickers( samples, {
			character: ( name ) => void this.attempt( () => this.pickCharacter( name ) ),
			clip: () => this.begin(),
			ground: ( name ) => void this.attempt( () => this.pickGround( name ) ),
			method: () => void this.attempt( () => this.pickMethods() ),
			files: ( files ) => void this.openFiles( files ),
			link: () => void this.copyLink(),
		} );
		if ( this.address.mode === 'keys' || this.address.mode === 'stand' )
		{
			this.choices.mode = this.address.mode;
		}
		const scene = addTab( 'scene', 'Scene' );
		const settings = addTab( 'settings', 'Settings' );
		const show = addTab( 'show', 'Show' );
		const checks = addTab( 'checks', 'Checks', () => this.refresh() );
		this.scenePage = new ScenePage( scene.page, this.choices, {
			populate: () => this.begin(), stages: () => this.takeSettings(), turned: () => this.turn( 0 ), body: () => this.session.setOpacity( this.choices.body ) } );
		this.settings = new SettingsPage( settings.page, library, () => this.takeSettings(), ( method ) => this.takeOwn( method ) );
		this.showPage = new ShowPage( show.page, library.drawInfos, this.address.show, () => this.refresh() );
		this.checks = new Checks( checks.page, () => this.refresh() );
		this.overlay = new Overlay( this.stage, this.checks );
		const tabs: Record<string, typeof scene> = { scene, settings, show, checks };
		( tabs[ this.address.panel ?? 'scene' ] ?? scene ).select();
		this.keys = new Keys( this.makeCommands() );
		this.listen();
	}

	// --------------------------------------------------------------------------------------------------------- loading

	/// Everything that the address asks for.
	async open(): Promise<void>
	{
		this.model = await this.loadCharacter( this.address.character );
		this.shape = await this.loadGround( this.address.scene );
		this.listClips( this.address.clip );
		this.pickers.show( 'character', this.model.name );
		this.pickers.show( 'ground', this.shape.name );
		this.pickers.methods = readMethods( this.address.method );
		if ( this.address.mode === null )
		{
			this.fitMode( null );
		}
		await this.pickMethods();
		if ( this.address.set.length > 0 )
		{
			this.settings.chooseChanges( Object.fromEntries( this.address.set ) );
		}
		this.transport.setPlaying( this.address.manual === false && this.address.time === null );
		if ( this.address.time !== null )
		{
			this.stepTo( this.address.time );
		}
	}

	/// Says what went wrong instead of stopping.
	private async attempt( action: () => Promise<void> | void ): Promise<void>
	{
		try
		{
			await action();
		}
		catch ( error )
		{
			say( messageOf( error ), true );
		}
		this.showPicked();
	}

	private async loadCharacter( name: string ): Promise<CharacterModel>
	{
		return new CharacterModel( name, await parseGlb( name, await fetchSample( name ) ) );
	}

	private async loadGround( name: string ): Promise<GroundShape>
	{
		const sample = this.samples.find( ( one ) => one.name === name );
		return new GroundShape( name, ( await parseGlb( name, await fetchSample( name ) ) ).scene, sample );
	}

	private async pickCharacter( name: string ): Promise<void>
	{
		if ( name !== this.model.name )
		{
			this.takeCharacter( await this.loadCharacter( name ) );
		}
	}

	private async pickGround( name: string ): Promise<void>
	{
		if ( name !== this.shape.name )
		{
			this.takeGround( await this.loadGround( name ) );
		}
	}

	/// The ancestors are loaded when one of them is first wanted.
	private async pickMethods(): Promise<void>
	{
		if ( needsMethods( this.pickers.methods ) )
		{
			await openMethods();
		}
		this.begin();
	}

	/// A ground that moves is stood on, one that does not is walked over; who goes by keys goes on.
	private fitMode( before: GroundShape | null ): void
	{
		const moved = ( before?.duration ?? null ) !== null;
		const moves = this.shape.duration !== null;
		if ( moved !== moves && this.choices.mode !== 'keys' )
		{
			this.choices.mode = moves ? 'stand' : 'path';
			this.scenePage.refresh();
		}
	}

	/// What is there stays until what is new has proved itself.
	private takeCharacter( model: CharacterModel ): void
	{
		const before = this.model;
		this.model = model;
		this.listClips( null );
		try
		{
			this.begin();
		}
		catch ( error )
		{
			this.model = before;
			this.listClips( null );
			this.begin();
			throw error;
		}
	}

	private takeGround( shape: GroundShape ): void
	{
		const before = this.shape;
		before.dispose();
		this.shape = shape;
		this.fitMode( before );
		this.begin();
	}

	private take( opened: Opened ): void
	{
		if ( opened.kind === 'character' )
		{
			this.takeCharacter( new CharacterModel( opened.name, opened.gltf ) );
		}
		else
		{
			this.takeGround( new GroundShape( opened.name, opened.object ) );
		}
		forgetMessages();
		say( `${opened.name}: opened as ${opened.kind}.` );
	}

	async openFiles( files: File[] ): Promise<void>
	{
		for ( const file of files )
		{
			await this.attempt( async () =>
			{
				/\.json$/i.test( file.name ) ? await this.settings.load( file ) : this.take( await openFile( file ) );
			} );
		}
	}

	private listClips( wanted: string | null ): void
	{
		this.pickers.fill( 'clip', this.model.clips.map( ( clip ) => [ clip.name, clip.name ] ) );
		const clip = this.model.findClip( wanted );
		if ( clip !== null )
		{
			this.pickers.show( 'clip', clip.name );
		}
	}

	private showPicked(): void
	{
		this.pickers.show( 'character', this.model.name );
		this.pickers.show( 'ground', this.shape.name );
	}

	// --------------------------------------------------------------------------------------------------------- session

	/// A new session of what is loaded and chosen. Throws where that can't be.
	begin(): void
	{
		const clip = this.model.findClip( this.pickers.value( 'clip' ) );
		const { methods } = this.pickers;
		const session = new Session( this.model, this.shape, clip, { ...this.choices, methods } );
		const first = this.session === undefined || this.session.model !== this.model || this.session.shape !== this.shape;
		this.stageTimes.stop();
		this.session?.dispose();
		this.session = session;
		this.stage.scene.add( session.group, this.shape.group );
		this.stage.views = methods.length > 1 && this.choices.count === 1 ? [ LAYER_FIRST, LAYER_SECOND ] : [ LAYER_FIRST ];
		const shown = this.choices.count > 1 ? methods.slice( -1 ) : methods;
		find( 'captions' ).replaceChildren( ...shown.map( ( method ) =>
			make( 'span', {}, method === 'none' ? methodLabels.none : `placed by ${methodLabels[ method ]}` ) ) );
		this.checks.show( session.findings );
		this.settings.show( methods, ( method ) => session.ownInfos( method ) );
		methods.filter( hasOwnSettings ).forEach( ( method ) => session.setOwn( method, this.settings.valuesOf( method ) ) );
		this.takeSettings();
		session.setOpacity( this.choices.body );
		this.restart();
		if ( first )
		{
			this.stage.resize();
			this.stage.frame( session.focus(), session.legLength, session.walker.root.heading );
		}
	}

	private takeSettings(): void
	{
		const values = applySwitches( this.settings.sole.values, this.choices.stages );
		// What carries roots alone, or nobody, is no ground for feet.
		this.session.settings.set( { ...values, 'probe.mask': ( values[ 'probe.mask' ]! & FEET_LAYERS ) >>> 0 } );
		this.refresh();
	}

	private takeOwn( method: MethodName ): void
	{
		this.session.setOwn( method, this.settings.valuesOf( method ) );
		this.refresh();
	}

	restart(): void
	{
		this.session.restart();
		this.behind = 0;
		this.plots.clear();
		this.stage.follow( this.session.focus(), 0, true );
		this.refresh();
	}

	// ------------------------------------------------------------------------------------------------------------ time

	private steer(): Steering
	{
		return this.choices.mode === 'keys' ? this.keys.steer( this.stage.camera ) : { amount: 0, heading: 0 };
	}

	/// So many frames of the simulation.
	private advance( steps: number ): void
	{
		// What may change at any time, without new bodies.
		const { mode, speed, height, weight } = this.choices;
		Object.assign( this.session.choices, { mode, speed, height, weight } );
		for ( let i = 0; i < steps; ++i )
		{
			this.session.step( this.steer() );
			this.plots.add( this.session.figures() );
			if ( this.choices.follow )
			{
				this.stage.follow( this.session.focus(), TIME_STEP, this.session.walker.jumped );
			}
			if ( this.recording === false )
			{
				this.stageTimes.hear( this.session.hero, this.costs );
			}
			this.session.cost().forEach( ( cost, index ) => { this.costs[ index ]! += ( cost - this.costs[ index ]! ) * 0.03; } );
		}
		if ( steps > 0 )
		{
			this.checks.hear( this.session.hero.told?.unmetTime ?? 0 );
			this.refresh();
		}
	}

	/// To the frame at a time, by the same steps whatever was before.
	stepTo( time: number ): void
	{
		const wanted = Math.round( time / TIME_STEP );
		if ( wanted < Math.round( this.session.time / TIME_STEP ) )
		{
			this.restart();
		}
		this.advance( wanted - Math.round( this.session.time / TIME_STEP ) );
		this.draw();
	}

	/// A picture, and the time that it stands for.
	tick( seconds: number ): void
	{
		this.framesPerSecond += ( 1 / Math.max( seconds, 1e-3 ) - this.framesPerSecond ) * 0.05;
		if ( this.transport.playing )
		{
			this.behind += seconds * this.transport.rate;
			const steps = Math.floor( this.behind / TIME_STEP );
			this.behind -= steps * TIME_STEP;
			this.advance( Math.min( steps, MOST_STEPS ) );
		}
		this.draw();
	}

	// --------------------------------------------------------------------------------------------------------- showing

	/// Gizmos and texts of the frame as it is now.
	private refresh(): void
	{
		if ( this.session !== undefined )
		{
			this.overlay.refresh( this.session, this.showPage.mask );
		}
	}

	draw(): void
	{
		this.stage.render();
		this.drawPage();
	}

	/// All of a picture but the scene.
	private drawPage(): void
	{
		this.overlay.draw( this.session );
		this.plots.draw();
		const [ gather, cast, solve ] = this.costs.map( ( cost ) => cost.toFixed( 1 ) );
		const solver = this.costs.reduce( ( sum, cost ) => sum + cost, 0 ).toFixed( 1 );
		const words = this.address.manual ? '' : `${this.framesPerSecond.toFixed( 0 )} fps · ${solver} µs a character: ` +
			`gather ${gather}, cast ${cast}, solve ${solve}`;
		this.transport.show( this.session.time, words );
	}

	/// What a frame costs before the graphics card has its turn, as a mean over some, and what that is then given.
	measureLoad( frames: number ): Load
	{
		const costs = [ 0, 0, 0 ];
		const begin = performance.now();
		for ( let i = 0; i < frames; ++i )
		{
			this.advance( 1 );
			this.drawPage();
			this.session.cost().forEach( ( cost, index ) => { costs[ index ]! += cost / frames; } );
		}
		const script = ( performance.now() - begin ) / frames;
		this.stage.render();
		const { calls, triangles } = this.stage.renderer.info.render;
		return { script, solver: costs.reduce( ( sum, cost ) => sum + cost, 0 ) / 1e3, calls, triangles };
	}

	/// What `sole replay` reads of all frames from the start to a time.
	record( time: number ): Uint8Array
	{
		const { hero } = this.session;
		this.stageTimes.stop();
		this.recording = true;
		hero.beginTrace();
		this.restart();
		this.stepTo( time );
		this.recording = false;
		return hero.endTrace();
	}

	/// What is seen now, as an address of a PNG. Only where pictures are kept: manual=1.
	picture(): string
	{
		this.draw();
		return this.stage.renderer.domElement.toDataURL( 'image/png' );
	}

	// ---------------------------------------------------------------------------------------------------------- acting

	private makeCommands(): Record<string, () => void>
	{
		return {
			Space: () => this.transport.toggle(), Period: () => this.transport.stepOnce(), KeyR: () => this.restart(),
			KeyQ: () => this.turn( TURN_STEP ), KeyE: () => this.turn( -TURN_STEP ),
			PageUp: () => this.hand.lift( LIFT * TIME_STEP ), PageDown: () => this.hand.lift( -LIFT * TIME_STEP ),
		};
	}

	private turn( degrees: number ): void
	{
		this.hand.turn( degrees );
		this.scenePage.refresh();
	}

	private listen(): void
	{
		addEventListener( 'dragover', ( event ) => { event.preventDefault(); find( 'drop' ).hidden = false; } );
		addEventListener( 'dragleave', ( event ) => { find( 'drop' ).hidden = event.relatedTarget === null; } );
		addEventListener( 'drop', ( event ) =>
		{
			event.preventDefault();
			find( 'drop' ).hidden = true;
			void this.openFiles( [ ...( event.dataTransfer?.files ?? [] ) ] );
		} );
	}

	private async copyLink(): Promise<void>
	{
		const changes = Object.entries( this.settings.changes ).map( ( [ name, value ] ) => `${name}:${value}` );
		const link = writeAddress( { scene: this.shape.name, clip: this.pickers.value( 'clip' ), method: this.pickers.methods.join( ',' ),
			mode: this.choices.mode === 'path' ? '' : this.choices.mode, show: this.showPage.names.join( ',' ), set: changes.join( ',' ) } );
		try
		{
			await navigator.clipboard.writeText( link );
			say( 'The link is in the clipboard.' );
		}
		catch
		{
			say( link );
		}
	}
}
