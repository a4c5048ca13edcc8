import launch.logging
from launch import Action, Condition, LaunchContext, SomeSubstitutionsType, Substitution
from launch.actions import LogInfo
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


class Banner(Action):
    """Prints a frame, and leaves a launch configuration behind."""

    def __init__(self, *, text: SomeSubstitutionsType, **kwargs):
        super().__init__(**kwargs)
        self.__text = normalize_to_list_of_substitutions(text)
        self.__logger = launch.logging.get_logger('banner')

    def execute(self, context: LaunchContext):
        text = perform_substitutions(context, self.__text)
        for line in ('*' * (len(text) + 4), f'* {text} *', '*' * (len(text) + 4)):
            self.__logger.info(line)
        context.launch_configurations['banner'] = 'shown'
        return [LogInfo(msg='banner done')]


class Repeat(Action):
    """As many actions as a launch configuration says."""

    def __init__(self, times, make, **kwargs):
        super().__init__(**kwargs)
        self.times, self.make = normalize_to_list_of_substitutions(times), make

    def execute(self, context):
        return [self.make(i) for i in range(int(perform_substitutions(context, self.times)))]


class Upper(Substitution):
    def __init__(self, text):
        super().__init__()
        self.text = normalize_to_list_of_substitutions(text)

    def perform(self, context):
        return perform_substitutions(context, self.text).upper()


class Weekday(Condition):
    def __init__(self):
        super().__init__(predicate=lambda context: context.environment.get('WEEKDAY', 'yes') == 'yes')
