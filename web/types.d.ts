// Shapes that several files share. The classes are in the files themselves.

type Film = import("./lab/player/film.ts").Film;
type Clock = import("./lab/player/clock.ts").Clock;

/** Values by their names. */
type Named<Value = any> = Record<string, Value>;

/** A hash of the tables of words; written by the build. */
declare const WORDS: string;

/** A table of a language: a text by its key, or one for each plural. */
type Words = Named<string | { [plural: string]: string; other: string }>;
type Values = Named<Message>;
interface Phrase {
  key: string;
  values?: Values;
}
/** What is said: a key, or what needs none such as a number or a symbol; a key with its values; parts; what makes a text. */
type Message = string | number | Phrase | Message[] | (() => string);

/** Colours of the page, as the style sheet has them. */
type Look = ReturnType<typeof import("./lab/common/dom.ts").theme>;

/** What pictures are painted in. */
type Shades = { look: Look; inks: Colors };

// What a number may be: a range, both ends included, and single values besides.
interface NumberRange {
  least: number;
  most: number;
  also: number[];
}

interface Part {
  shape: "ring" | "disk" | "point_mass" | "rod";
  mass: number;
  at?: number;
  [measure: string]: any;
}

interface Scenario {
  duration: number;
  hoop: Named & { parts?: Part[] };
  plane: Named;
  start: Named;
  contact: Named;
}

interface Sentence {
  t: number;
  mode: string;
  text: Message;
}

interface Phase {
  mode: string;
  from: number;
  to: number;
}

interface Pose extends MotionState {
  mode: string;
  normal_force: number;
  friction_force: number;
  [column: string]: any;
}

type Column = Float64Array | Float32Array | Uint8Array;

/** What the player knows of a motion besides its frames. */
type FilmHeader = ReturnType<typeof import("./model/header.ts").headerOf> & { doubt?: Message };
type MapHeader = ReturnType<typeof import("./model/cells.ts").mapReply>["header"];

interface Reply<Header> {
  header: Header;
  arrays: Named;
}

interface FilmReply extends Reply<FilmHeader> {
  /** The columns at one time. */
  exact(time: number): Named<Column>;
}

type Change = [path: string, value: unknown];

type Backend = import("./lab/backend/backend.ts").Backend;

/** What is drawn of the hoop; `ahead`: the path that is to come, while it is held. */
type StageOptions = Record<"traces" | "forces" | "speed" | "whole" | "three" | "ahead", boolean>;

interface Point {
  clientX: number;
  clientY: number;
}

type AxisName = "x" | "y";

// A place on a map, in the units of its axes.
interface Place {
  x: number;
  y: number;
}

interface Box {
  width: number;
  height: number;
}

interface MapClass {
  name: string;
  text: Message;
  color: string;
}

/** A computed part of a map; a finer one lies over a coarser one. */
type MapLayer = ReturnType<typeof import("./lab/map/map_layers.ts").layerOf>;

interface Curve {
  name: string;
  color?: string;
  dash?: number[];
  values: Column;
}

interface PlotDefinition {
  key: string;
  title: string;
  unit: string;
  curves: (film: Film) => Curve[];
  limits?: [number, number];
}

// What all diagrams have in common.
type PlotShared = { axis: string; range: number[] | null; clock: Clock; changed: () => void };

type Vector = number[]; // of three
type Matrix = Float32Array<ArrayBuffer>; // columns of four

interface Program {
  program: WebGLProgram;
  uniforms: Named<WebGLUniformLocation | null>;
  attributes: Named<number>;
}

type Mesh = ReturnType<typeof import("./space/gl.ts").mesh>;

// A camera: `eye` and `target` are level, `angle` is that of the view.
interface View {
  eye: Vector;
  target: Vector;
  slope: number;
  angle: number;
  near: number;
  far: number;
}

// `tube` and `broad` are half the rim's thickness and half its breadth; `plain` is its colour where speed has none.
interface Ring {
  center: Vector;
  radius: number;
  tube: number;
  broad: number;
  angle: number;
  velocity: number[];
  omega: number;
  plain?: Vector | null;
}

// The film that turns, as animate/web.py writes it.
interface SceneHoop {
  label: string;
  tag: string;
  radius: number;
  eccentricity: number;
  load: number;
  frames: Named<Float32Array>;
  path: Named<Float32Array> | null;
  marks: [number, number, string, string][]; // when, how far along the plane, which kind, in a word
}

interface SceneData {
  fps: number;
  rate: Float32Array; // of each frame
  slope: number;
  extent: { left: number; right: number; speed: number };
  grid: number;
  newton: number | null; // length of a newton's arrow [m]
  flies: boolean;
  theme: { paper: string; ground: string; ink: string; muted: string; dark: boolean };
  colors: { gravity_center: string; airborne: string; normal_force: string; friction_force: string };
  modes: [string, string][];
  hoops: SceneHoop[];
}

// --- The page without a server: what it needs of the kernel that is compiled to WebAssembly -------------------------

// A scenario as numbers in SI units and radians, whichever way it was given: `given()` of model/given.ts makes it.
interface Given extends Omit<CheckedPlane, "mu">, Omit<CheckedHoop, "load_fraction" | "parts">, Omit<MotionState, "t"> {
  ideal: boolean; // given by its load fraction: κ = 1 − ε²
  slip: number; // v_t: exactly 0 in a rolling start, else vx − radius · omega
  mode: ModeLetter | null; // of a start that goes on; else it follows from the state
  rolling: boolean; // the scenario has start.speed: theory's numbers of a rolling start are asked for with vx
  duration: number;
  max_events: number;
  contact: Named | null; // of a compliant one
}

/** What checking a scenario needs of mechanics. All at once: nothing is awaited while a scenario is read. */
type Mechanics = Pick<import("./kernel/module.ts").HoopModule, "ideal" | "combine" | "instant" | "refused" | "chosen">;

// As Trajectory.to_dict has it.
interface ComputedMotion {
  status: MotionStatus;
  sequence: string;
  fingerprint: string;
  events: MotionEvent[];
  final: MotionState & { mode: ModeLetter };
  energy: Named<number>;
  duration: number;
  doubt: number | null; // from when on doubles do not decide what comes, null where they do [s]
}

// Places of a motion's state: the fields of results.Sample. `mode` is the place of the letter in "RSKHM".
type Samples = Named<Float64Array>;

/**
 * What theory knows, as theory.summary: null where there is no such number, Infinity where there is no limit.
 * Numbers of a rolling start are null unless `given.rolling` and `given.angle` is 0.
 */
type ThresholdName =
  | "first_slip_speed"
  | "first_hop_speed"
  | "immediate_hop_speed"
  | "needed_friction"
  | "painleve_friction"
  | "painleve_angle"
  | "stable_angle"
  | "massless_loss_angle"; // of a start that does not roll: at speed 0
type TheoryNumbers = Record<ThresholdName, number | null> & {
  jam_angles: number[]; // in the order of jam_states
  massless_loss_by_friction: boolean;
};

/** The cells of a map: rows in the order of `tables.cell`, maps.kernel.CELL, one number a cell in each. */
interface MapCells {
  count: number;
  rows: Float64Array; // rows.length = tables.cell.length * count; `allowed` is 0 where values do not go together
}

interface MapValues {
  values: Float32Array | Float64Array; // one a cell; nan where there is none; of a coded quantity the code
  sequences?: string[]; // of "sequence": what its codes stand for
}

/** What the module answers at once. */
type Calls = Pick<
  import("./kernel/module.ts").HoopModule,
  "film" | "motion" | "columns" | "samples" | "thresholds" | "regions" | "fate" | "map"
>;

/** What answers by workers; tests have another one. */
type Kernel = Pick<import("./kernel/kernel.ts").WorkerKernel, "ask" | "limit">;

// What becomes of a motion in the end; nan is what it has not [SI].
interface Fate {
  fate: string;
  hops: number;
  passages: number;
  turns: number; // revolutions in a period
  mean_speed: number;
  final_omega: number;
}

// --- A scenario that has been checked: web/model ---------------------------------------------------------------------

interface CheckedContact {
  model: "rigid" | "compliant";
  max_events: number;
  [key: string]: any;
}

interface Checked {
  duration: number;
  hoop: CheckedHoop;
  plane: CheckedPlane;
  start: CheckedStart;
  contact: CheckedContact;
}

// --- Written by Python: static/tables.json, which the compiler checks against `Tables`, and motions --------------------

interface CheckedHoop {
  radius: number;
  mass: number;
  load_fraction: number | null;
  eccentricity: number;
  inertia_ratio: number; // 0 for the massless hoop
  parts: Part[] | null;
}

interface CheckedPlane {
  gravity: number;
  slope: number;
  mu: number | null;
  mu_static: number;
  mu_kinetic: number;
  restitution: number;
  impact_law: "stronge" | "newton" | "poisson";
  painleve: "flight" | "impact";
  rolling_resistance: number;
}

interface CheckedStart {
  x: number;
  height: number;
  angle: number;
  speed: number | null;
  vx: number;
  vy: number;
  omega: number | null;
  slip: number | null; // of a start that goes on from another motion, as its mode
  mode: ModeLetter | null;
}

type RangeTable = { least: number; most: number; unit?: string; also?: (number | string)[] };
type Written = typeof import("../src/hophoop/lab/static/tables.json");
type Setup = Written["setup"] & { colors: Colors };
type Colors = Record<"modes" | "mode_names", Named<string>> & Written["setup"]["colors"];
type ControlsInfo = Setup["controls"];
type SliderInfo = ControlsInfo["groups"]["hoop"][number];
type ChoiceInfo = ControlsInfo["choices"][number];
type AxisInfo = ControlsInfo["map_axes"][number];
type Preset = Setup["presets"][number];

interface FieldTable {
  kind: string;
  unit: string;
  nullable?: boolean;
  required?: boolean;
  default?: any;
  range?: RangeTable;
  options?: string[];
}

interface Tables {
  setup: Setup;
  fingerprints: Named<string>;
  schema: string;
  scenario: {
    sections: Named<string[]>;
    models: Named<{ place: string; fields: Named<FieldTable> }>;
    parts: Named<string>;
    ends: Named<string[]>;
    left_out: Named;
    rules: ({ sentence: string; values: Named; known: Named; number: string } | null)[];
    touch: number;
    default: Named;
  };
  texts: Named<string>;
  words: Written["words"];
  classes: { codes: Named<Named<string>> } & Record<"families" | "massless", Named<string>> &
    Record<"hops" | "rolls" | "other", string>;
  map: { allowed: Named<RangeTable>; quantities: Named<{ span: string; unit: string; words: string[] }> };
  lab: Named<string>;
  limits: Written["limits"];
  table: { rate: number; variables: Named<string> };
  shown: string[];
  curves: Named<{ field: string; color: string }[]>;
}

// biome-ignore format: a list
type EventKind = "start" | "slip_start" | "stick" | "slip_reversal" | "takeoff" | "impact" | "turn" | "apex" | "bounce_limit"
  | "painleve_inconsistent" | "painleve_indeterminate" | "jam" | "kane_gain" | "skim" | "rest" | "end";
type ModeLetter = "R" | "S" | "K" | "H" | "M";
type MotionStatus = "completed" | "at_rest" | "jammed" | "undetermined" | "event_limit";

interface MotionState {
  t: number;
  x: number;
  height: number;
  angle: number;
  vx: number;
  vy: number;
  omega: number;
}

interface MotionEvent extends MotionState {
  kind: EventKind;
  from: ModeLetter | null;
  to: ModeLetter;
  before: Record<"vx" | "vy" | "omega", number | null>;
  impulse: Record<"normal" | "tangential", number | null>;
  collision?: boolean;
  gain?: number | null;
  stable?: boolean | null;
}

// A canvas whose strokes become an SVG.
declare module "svgcanvas" {
  export class Context extends CanvasRenderingContext2D {
    constructor(options: { width: number; height: number; document: Document });
    getSerializedSvg(): string;
  }
}
