// Types of what Python sends, written by `python -m hophoop.lab.tables`.

type WholePart = RingPart | DiskPart | PointMassPart | RodPart;

interface RingPart {
  shape: "ring";
  mass: number;
  inner_radius: number;
  outer_radius: number;
}

interface DiskPart {
  shape: "disk";
  mass: number;
  radius: number;
  at: number;
}

interface PointMassPart {
  shape: "point_mass";
  mass: number;
  at: number;
}

interface RodPart {
  shape: "rod";
  mass: number;
  length: number;
  at: number;
  direction: "radial" | "tangential";
}

interface CheckedHoop {
  radius: number;
  mass: number;
  load_fraction: number | null;
  eccentricity: number;
  inertia_ratio: number;
  parts: WholePart[] | null;
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
  slip: number | null;
  mode: "R" | "S" | "K" | "H" | null;
  exact: number[] | null;
}

interface RigidContact {
  model: "rigid";
  max_events: number;
}

interface CompliantContact {
  model: "compliant";
  stiffness: number | null;
  damping: number | null;
  restitution: number | null;
  law: "kelvin-voigt" | "hunt-crossley";
  friction: "tanh" | "linear" | "bristle";
  slip_speed: number | null;
  tangential_stiffness: number | null;
  rtol: number | null;
  max_events: number;
}

interface AllowedRange {
  least: number;
  most: number;
  also: (number | "inf")[];
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
  allowed: AllowedRange;
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
  allowed: [number, number];
}

interface ControlsInfo {
  groups: Record<string, SliderInfo[]>;
  choices: ChoiceInfo[];
  gravities: [string, number][];
  map_axes: AxisInfo[];
}

interface Preset {
  key: string;
  group: string;
  title: string;
  text: string;
  query: string;
}

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

interface Setup {
  version: string;
  controls: ControlsInfo;
  map_quantities: [string, string][];
  presets: Preset[];
  colors: Colors;
}

interface RangeTable {
  least: number;
  most: number;
  unit?: string;
  also?: (number | "inf")[];
}

interface FieldTable {
  kind: "number" | "friction" | "whole" | "word" | "parts" | "section";
  unit: string;
  nullable?: boolean;
  required?: boolean;
  default?: any;
  limits?: [string, number][];
  range?: RangeTable;
  options?: string[];
}

interface ModelTable {
  place: string;
  fields: Record<string, FieldTable>;
}

interface RuleTable {
  sentence: string;
  values: Record<string, string>;
  known: Record<string, any>;
  number: string;
}

interface ScenarioTable {
  sections: Record<string, string[]>;
  models: Record<string, ModelTable>;
  parts: Record<string, string>;
  ends: Record<string, string[]>;
  left_out: Record<string, any>;
  rules: (RuleTable | null)[];
  touch: number;
  default: Record<string, any>;
}

interface WordsTable {
  letters: string;
  modes: string[];
  summed_up: EventKind[];
  signs: Record<string, string>;
  least_speed: number;
}

interface ClassesTable {
  codes: Record<string, Record<string, string>>;
  families: Record<string, string>;
  massless: Record<string, string>;
  hops: string;
  rolls: string;
  other: string;
}

interface MapQuantityTable {
  span: string;
  unit: string;
  words: string[];
}

interface MapTable {
  events: number;
  flight_turns: number;
  allowed: Record<string, RangeTable>;
  rates: Record<string, string>;
  quantities: Record<string, MapQuantityTable>;
}

interface LimitsTable {
  duration: number;
  events: number;
  parts: number;
  samples: number;
  cells: number;
  turns: number;
  map_turns: number;
  steps: number;
  changes: number;
  film: number;
}

interface SamplesTable {
  rate: number;
  variables: Record<string, string>;
}

interface Tables {
  setup: Setup;
  fingerprints: Record<string, string | null>;
  schema: string;
  scenario: ScenarioTable;
  texts: Record<string, string>;
  words: WordsTable;
  classes: ClassesTable;
  map: MapTable;
  lab: Record<string, string>;
  limits: LimitsTable;
  table: SamplesTable;
  shown: string[];
}

type EventKind =
  | "start"
  | "slip_start"
  | "stick"
  | "slip_reversal"
  | "takeoff"
  | "impact"
  | "turn"
  | "apex"
  | "bounce_limit"
  | "painleve_inconsistent"
  | "painleve_indeterminate"
  | "jam"
  | "kane_gain"
  | "skim"
  | "rest"
  | "end";

type ModeLetter = "R" | "S" | "K" | "H" | "M";

type MotionStatus = "completed" | "at_rest" | "jammed" | "undetermined" | "event_limit";

interface Velocities {
  vx: number | null;
  vy: number | null;
  omega: number | null;
}

interface Impulse {
  normal: number | null;
  tangential: number | null;
}

interface MotionEvent {
  t: number;
  x: number;
  height: number;
  angle: number;
  vx: number;
  vy: number;
  omega: number;
  kind: EventKind;
  from: ModeLetter | null;
  to: ModeLetter;
  before: Velocities;
  impulse: Impulse;
  collision?: boolean;
  gain?: number | null;
  stable?: boolean | null;
}

interface FinalState {
  t: number;
  x: number;
  height: number;
  angle: number;
  vx: number;
  vy: number;
  omega: number;
  mode: ModeLetter;
}

interface SentMotion {
  status: MotionStatus;
  sequence: string;
  fingerprint: string;
  events: MotionEvent[];
  final: FinalState;
  energy: Record<string, number>;
  query: string;
  duration: number;
  turning: Record<string, number>;
}
