"""Why changes of scenarios, files and the store of maps cannot be seen."""

# fmt: off
REASONS: dict[str, tuple[tuple[str, str, str, str], ...]] = {
    "how many times something is tried, or how many digits a name has, is a choice": (
        ("io", "", "MOST_READS = 100", "MOST_READS = 101"),
        ("io", "", "MOST_READS = 100", "MOST_READS = 99"),
        ("files", "replacing", "temporary = Path(folder) / f\".{uuid.uuid4().hex[:12]}.{target.name}\"", "temporary = Path(folder) / f\".{uuid.uuid4().hex[: 13]}.{target.name}\""),
        ("files", "replacing", "temporary = Path(folder) / f\".{uuid.uuid4().hex[:12]}.{target.name}\"", "temporary = Path(folder) / f\".{uuid.uuid4().hex[: 11]}.{target.name}\""),
        ("files", "_put_folder", "old = target.with_name(f\".{uuid.uuid4().hex[:12]}.old\")", "old = target.with_name(f\".{uuid.uuid4().hex[: 13]}.old\")"),
        ("files", "_put_folder", "old = target.with_name(f\".{uuid.uuid4().hex[:12]}.old\")", "old = target.with_name(f\".{uuid.uuid4().hex[: 11]}.old\")"),
        ("files", "_put_folder", "for _ in range(1000):", "for _ in range( 1001):"),
        ("files", "_put_folder", "for _ in range(1000):", "for _ in range( 999):"),
        ("store", "_create", "fresh = path.with_name(f\".{os.urandom(6).hex()}.{path.name}\")", "fresh = path.with_name(f\".{os.urandom( 7).hex()}.{path.name}\")"),
        ("store", "_create", "fresh = path.with_name(f\".{os.urandom(6).hex()}.{path.name}\")", "fresh = path.with_name(f\".{os.urandom( 5).hex()}.{path.name}\")"),
    ),
    "how many bytes are read at once": (
        ("formats", "_decoded", "content = stream.read(MOST_BYTES + 1)", "content = stream.read(MOST_BYTES + 2)"),
        ("checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 2 << 20))"),
        ("checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 1 << 21))"),
        ("checksum", "is_broken", "piece = stream.read(min(length, 1 << 20))", "piece = stream.read(min(length, 1 << 19))"),
    ),
    "behind what was read to its end is the end": (
        ("checksum", "seal", "stream.seek(0, 2)", "stream.seek(0, 1)"),
    ),
    "columns of one table have the same length": (
        ("save", "write_csv", "_write_rows(Path(path), header, zip(*(column.tolist() for column in columns), strict=True))", "_write_rows(Path(path), header, zip(*(column.tolist() for column in columns), strict=False))"),
        ("io", "_unpacked", "first = dataset[layout[0][0]]", "first = dataset[layout[ 1][0]]"),
        ("io", "_unpacked", "first = dataset[layout[0][0]]", "first = dataset[layout[ -1][0]]"),
        ("io", "_unpacked", "table = np.empty(first.shape[0], dtype=np.dtype(layout))", "table = np.empty(first.shape[ -1], dtype=np.dtype(layout))"),
    ),
    "JSON reads the same with and without escapes": (
        ("save", "_attributes", "\"scenario\": json.dumps(motion.scenario.to_dict(), ensure_ascii=False),", "\"scenario\": json.dumps(motion.scenario.to_dict(), ensure_ascii=True),"),
    ),
    "only another process at the same moment makes a difference": (
        ("files", "_put_folder", "shutil.rmtree(fresh, ignore_errors=True)", "shutil.rmtree(fresh, ignore_errors=False)"),
        ("store", "finish", "left.unlink(missing_ok=True)", "left.unlink(missing_ok=False)"),
    ),
    "an array or a group that is not there yet": (
        ("save", "save", 'mode = "w" if name == "/" else "a"', 'mode = "w" if name != "/" else "a"'),
        ("save", "save", 'mode = "w" if name == "/" else "a"', 'mode = "w" if not name == "/" else "a"'),
        ("store", "", "def _create_array(group: Any, plan: Plan, quantity: Quantity, dtype: str, overwrite: bool = False) -> Any:", "def _create_array(group: Any, plan: Plan, quantity: Quantity, dtype: str, overwrite: bool = True) -> Any:"),
    ),
    "what pydantic says besides, which is not read": (
        ("sentences", "sentence", "return findings_sentence(error.errors(include_url=False), _PLACES.get(error.title, error.title.lower()))", "return findings_sentence(error.errors(include_url=True), _PLACES.get(error.title, error.title.lower()))"),
    ),
    "of several near names the nearest is the first, and one is asked for": (
        ("base", "Frozen._known_keys", "close = difflib.get_close_matches(str(key), known, n=1)", "close = difflib.get_close_matches(str(key), known, n= 2)"),
        ("base", "Frozen._known_keys", 'hint = say("did_you_mean", close=close[0]) if close else say("known_are", known=", ".join(known))', 'hint = say("did_you_mean", close=close[ -1]) if close else say("known_are", known=", ".join(known))'),
    ),
    "nothing in a frozen model can change": (
        ("base", "", "def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:", "def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = True) -> Self:"),
    ),
    "the only one is the first and the last": (
        ("models", "Hoop._complete", 'raise refuse(say("half_a_hoop", missing=missing, given=given[0]))', 'raise refuse(say("half_a_hoop", missing=missing, given=given[ -1]))'),
    ),
    "a case that never comes: only a rolling start has no omega of its own": (
        ("models", "Start.state", "omega = self.omega if self.omega is not None else 0.0", "omega = self.omega if self.omega is not None else 1.0"),
        ("models", "Start.state", "omega = self.omega if self.omega is not None else 0.0", "omega = self.omega if self.omega is not None else -1.0"),
    ),
    "a length that this kind of part does not have, and nothing reads": (
        ("parts", "Disk.row", "return mass.DISK, self.mass, self.radius, 0.0, self.at", "return mass.DISK, self.mass, self.radius, 1.0, self.at"),
        ("parts", "Disk.row", "return mass.DISK, self.mass, self.radius, 0.0, self.at", "return mass.DISK, self.mass, self.radius, -1.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 1.0, 0.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, -1.0, 0.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 0.0, 1.0, self.at"),
        ("parts", "PointMass.row", "return mass.POINT_MASS, self.mass, 0.0, 0.0, self.at", "return mass.POINT_MASS, self.mass, 0.0, -1.0, self.at"),
        ("parts", "Rod.row", "return kind, self.mass, self.length, 0.0, self.at", "return kind, self.mass, self.length, 1.0, self.at"),
        ("parts", "Rod.row", "return kind, self.mass, self.length, 0.0, self.at", "return kind, self.mass, self.length, -1.0, self.at"),
    ),
    "only the order counts": (
        ("paths", "_rank", 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)', 'return (section == "start", -1 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)'),
        ("paths", "_rank", 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)', 'return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 3)'),
    ),
    "keys and words are plain letters": (
        ("scenario", "Scenario.save", 'text = json.dumps(self.to_dict(), indent=2, ensure_ascii=False) + "\\n"', 'text = json.dumps(self.to_dict(), indent=2, ensure_ascii=True) + "\\n"'),
    ),
    "only arrays and numbers of NumPy have an item, and these have dimensions": (
        ("sentences", "_show", 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value))', 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 2) == 0 else value))'),
        ("sentences", "_show", 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 1) == 0 else value))', 'return shortened(repr(value.item() if hasattr(value, "item") and getattr(value, "ndim", 0) == 0 else value))'),
    ),
}
# fmt: on
