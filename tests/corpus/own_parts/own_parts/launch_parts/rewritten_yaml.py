"""Our own stand-in for the substitution that navigation stacks use: a parameter file with some values replaced."""
import tempfile
from typing import Dict, Text

import launch
import yaml
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


class RewrittenYaml(launch.Substitution):
    def __init__(self, source_file: launch.SomeSubstitutionsType, rewrites: Dict, convert_types=False) -> None:
        super().__init__()
        self.__source = normalize_to_list_of_substitutions(source_file)
        self.__rewrites = {key: normalize_to_list_of_substitutions(value) for key, value in rewrites.items()}
        self.__convert = convert_types

    @property
    def name(self):
        return self.__source

    def describe(self) -> Text:
        return ''

    def perform(self, context: launch.LaunchContext) -> Text:
        with open(perform_substitutions(context, self.name)) as f:
            data = yaml.safe_load(f)
        rewrites = {key: self.convert(launch.utilities.perform_substitutions(context, value)) for key, value in self.__rewrites.items()}
        self.walk(data, rewrites)
        out = tempfile.NamedTemporaryFile(mode='w', delete=False)
        yaml.dump(data, out)
        out.close()
        return out.name

    def walk(self, data, rewrites):
        try:
            for key in data.keys():
                if key in rewrites:
                    data[key] = rewrites[key]
                self.walk(data[key], rewrites)
        except AttributeError:
            return

    def convert(self, text):
        if self.__convert:
            try:
                return float(text) if '.' in text else int(text)
            except ValueError:
                pass
        return {'true': True, 'false': False}.get(text.lower(), text)
