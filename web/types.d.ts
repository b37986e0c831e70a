// What Python sends, and the shapes that several files share. The classes are in the files themselves.

type Film = import("./lab/film.js").Film;
type Clock = import("./lab/clock.js").Clock;

interface Colors {
  modes: Record<string, string>;
  mode_names: Record<string, string>;
  gravity_center: string;
  airborne: string;
  center_speed: string;
  rotation_speed: string;
  kinetic: string;
  potential: string;
  friction_loss: string;
  impact_loss: string;
  normal_force: string;
  friction_force: string;
  limit: string;
}

// Colours of the page, as the style sheet has them.
interface Look {
  ink: string;
  soft: string;
  line: string;
  paper: string;
  panel: string;
  ground: string;
  font: string;
  dark: boolean;
}

interface Preset {
  key: string;
  group: string;
  title: string;
  text: string;
  query: string;
}

interface SliderInfo {
  path: string;
  label: string;
  symbol: string;
  unit: string;
  help: string;
  least: number;
  most: number;
  step: number;
  logarithmic: boolean;
  degrees: boolean;
}

interface ChoiceInfo {
  path: string;
  label: string;
  options: [string, string][];
  help: string;
}

interface AxisInfo {
  path: string;
  label: string;
  unit: string;
  degrees: boolean;
  range: [number, number];
}

interface ControlsInfo {
  groups: Record<string, SliderInfo[]>;
  choices: ChoiceInfo[];
  gravities: [string, number][];
  map_axes: AxisInfo[];
}

interface Setup {
  version: string;
  controls: ControlsInfo;
  map_quantities: [string, string][];
  presets: Preset[];
  colors: Colors;
}

interface Part {
  shape: "ring" | "disk" | "point_mass" | "rod";
  mass: number;
  at?: number;
  [measure: string]: any;
}

interface Scenario {
  duration: number;
  hoop: Record<string, any> & { parts?: Part[] };
  plane: Record<string, any>;
  start: Record<string, any>;
  contact: Record<string, any>;
}

interface MotionEvent {
  t: number;
  kind: string;
  angle: number;
  [key: string]: any;
}

interface Sentence {
  t: number;
  event: number;
  mode: string;
  text: string;
}

interface Phase {
  mode: string;
  from: number;
  to: number;
}

interface Pose {
  t: number;
  mode: string;
  x: number;
  height: number;
  angle: number;
  vx: number;
  vy: number;
  omega: number;
  normal_force: number;
  friction_force: number;
  [column: string]: any;
}

type Column = Float64Array | Float32Array | Uint8Array;

interface Reply {
  header: any;
  arrays: Record<string, any>;
}

type Change = [path: string, value: unknown];

// Where answers come from: the server of the page, or the notebook's kernel.
interface Backend {
  shares: boolean;
  call(name: string, body: object, signal?: AbortSignal): Promise<Reply>;
  file(name: string, query: string): Promise<Blob>;
  link(query: string, hash: string): string | null;
}

// What is drawn of the hoop.
interface StageOptions {
  traces: boolean;
  forces: boolean;
  speed: boolean;
  whole: boolean;
  three: boolean;
}

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
  text: string;
  color: string;
}

interface MapHeader {
  x: { path: string; from: number; to: number; cells: number };
  y: { path: string; from: number; to: number; cells: number };
  what: string;
  label: string;
  unit: string;
  classes: MapClass[] | null;
}

// A computed part of a map; a finer one lies over a coarser one.
interface MapLayer {
  picture: HTMLCanvasElement;
  header: MapHeader;
  values: Float32Array;
  x: number[];
  y: number[];
  low: number;
  high: number;
}

interface Curve {
  name: string;
  color?: string;
  dash?: "solid" | "dash" | "dot";
  values: Column;
}

interface PlotDefinition {
  key: string;
  title: string;
  unit: string;
  curves: (film: Film) => Curve[];
  limits?: [number, number];
  symmetric?: boolean;
}

// What all diagrams have in common.
interface PlotShared {
  axis: string;
  range: number[] | null;
  clock: Clock;
  changed: () => void;
}

type Vector = number[]; // of three
type Matrix = Float32Array; // columns of four
type Camera = import("./scene/camera.js").Camera;

interface Program {
  program: WebGLProgram;
  uniforms: Record<string, WebGLUniformLocation | null>;
  attributes: Record<string, number>;
}

interface Mesh {
  vertices: WebGLBuffer;
  elements: WebGLBuffer | null;
  parts: Record<string, number>;
  stride: number;
  count: number;
}

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

// A flat piece of the plane.
interface Sheet {
  data: number[];
  indices: number[];
}

// A hoop of the film that turns, at one instant.
interface ScenePose {
  hoop: SceneHoop;
  center: Vector;
  angle: number;
  velocity: number[];
  omega: number;
  airborne: boolean;
  at: (distance: number) => Vector;
}

// The film that turns, as animate/web.py writes it.
interface SceneHoop {
  label: string;
  lane: number;
  radius: number;
  load: number;
  heavy: number;
  mode: number[];
  t: Float32Array;
  center: Float32Array;
  contact: Float32Array;
  angle: Float32Array;
  velocity: Float32Array;
  omega: Float32Array;
  normalForce: Float32Array;
  frictionForce: Float32Array;
  traces: SceneTraces | null;
  tag: string;
  marks: [number, number, string, string][]; // when, how far along the plane, which kind, in a word
}

interface SceneTraces {
  t: Float32Array;
  load: Float32Array;
  heavy: Float32Array;
  airborne: number[];
}

interface SceneData {
  fps: number;
  count: number;
  slope: number;
  radius: number;
  along: [number, number];
  height: number;
  grid: number;
  topSpeed: number;
  newton: Float32Array | null; // length of a newton's arrow at each frame
  flies: boolean;
  map: number[][];
  theme: { background: string; ground: string; ink: string; muted: string; load: string; dark: boolean };
  colors: { center: string; airborne: string; normal: string; friction: string };
  flight: number;
  rate: Float32Array;
  modes: [string, string][];
  hoops: SceneHoop[];
}
